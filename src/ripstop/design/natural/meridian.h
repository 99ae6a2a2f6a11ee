#pragma once

#include <vector>

namespace ripstop {

/// A point of the meridian, or (from `MeridianEquation::slope`) the derivative of each entry along it.
struct MeridianPoint {
    double s = 0;        ///< arc length from the mouth [m]
    double r = 0;        ///< distance from the axis; that of the tape if the envelope is lobed [m]
    double z = 0;        ///< height above the mouth plane [m]
    double theta = 0;    ///< angle from the vertical, positive where r grows upward [rad]
    double tension = 0;  ///< total meridional force T round the whole circle: of the cloth if smooth, of all tapes if
                         ///< lobed [N]
    double area = 0;     ///< area of cloth below this point [m2]
    double volume = 0;   ///< volume enclosed between the mouth plane and this point [m3]
};

/// The equilibrium of the meridian of a hot-air envelope without hoop tension (Upson 1939; Smalley; Baginski).
///
/// Smooth (`bulge` 0): the cloth carries T along the meridian and no hoop tension. With p = b z,
///
///     r' = sin th,  z' = cos th,  T' = W cos th,  T th' = -2 pi r p - W sin th,  W = 2 pi r w + n g
///     A' = 2 pi r,  V' = pi r2 cos th
///
/// where w is the weight of the cloth and n the number of tapes of weight g per length. T is the total force, so
/// nothing is singular on the axis.
///
/// Lobed: between n tapes the cloth forms arcs of half-angle B and carries hoop tension only, N_h = p rho. With a =
/// pi/n, half chord c = r sin a, radius rho = c / sin B, d the mean normal offset of the lobe, and p taken at
/// z - d sin th:
///
///     R = 2 p c [(1 - th' d) cos th cos a - sin a / tan B],  Z = -2 p c (1 - th' d) sin th    per tape and length
///     T' = -n (R sin th + Z cos th) + W cos th,  T th' = -n (R cos th - Z sin th) - W sin th
///     V' = n [r2 sin a cos a cos th + (B - sin B cos B) rho2 (1 - th' d_c)]
///
/// W = n (2 rho B w + g), and A' is the true area of the lobed cloth. d_c is the offset of the lobe section's
/// centroid. To leading order the lobes add a mean hoop tension k p r, k = sin a / tan B, to the smooth equation: a
/// lobed envelope is taller than a smooth one. Accurate for B up to 30 to 45 degrees.
struct MeridianEquation {
    double buoyancy = 1;     ///< b [N/m3]
    double weight = 0;       ///< w: weight of the cloth [N/m2]
    int tapes = 24;          ///< n: number of tapes
    double tape_weight = 0;  ///< g: weight of one tape [N/m]
    double bulge = 0;        ///< B, half-angle of the lobes [rad]; 0: smooth

    MeridianPoint slope(const MeridianPoint& at) const;
    /// One fifth-order Runge-Kutta step along the meridian (Dormand-Prince).
    MeridianPoint step(const MeridianPoint& from, double length) const;
};

/// A meridian from the mouth to the axis.
struct Meridian {
    MeridianEquation equation;
    std::vector<MeridianPoint> stations;  ///< the integrator's steps, with increasing s
    bool on_axis = false;                 ///< it ended on the axis; otherwise it diverged and the stations end there

    double length() const { return stations.back().s; }
    /// The point at arc length s in [0, length()], as accurate as the stations: one step from the station below.
    MeridianPoint at(double s) const;
    /// The widest point of the meridian: th = 0.
    MeridianPoint equator() const;
    /// The point above the equator where the radius has decreased to r; the end if there is none.
    MeridianPoint descent_to(double r) const;
};

/// Integrates the equation from `start` until the meridian reaches the axis, with adaptive steps of order 5(4).
/// `unit` is the length scale of errors: each step has an error below 1e-13 of it.
Meridian trace_meridian(const MeridianEquation& equation, const MeridianPoint& start, double unit);

}  // namespace ripstop
