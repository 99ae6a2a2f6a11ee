#pragma once

#include <optional>

#include "ripstop/base/solve_summary.h"
#include "ripstop/design/natural/meridian.h"
#include "ripstop/model/flight/air.h"

namespace ripstop {

/// The options of a natural shape. Its size is given by the diameter if set, else the load if set, else the volume.
struct NaturalShapeOptions {
    double volume = 3000;             ///< [m3], > 0
    std::optional<double> diameter;   ///< twice the largest radius (of the tapes if lobed) [m], > 0
    std::optional<double> load;       ///< load at the mouth [N], > 0
    double mouth_ratio = 0.26;        ///< radius of the mouth relative to the largest, [0, 0.8]; 0: closed to a point
    double buoyancy = 2.7365;         ///< b [N/m3], > 0
    double weight = 0.065 * gravity;  ///< weight of the cloth [N/m2], >= 0
    int tapes = 24;                   ///< 3 to 1000
    double tape_weight = 0;           ///< weight of one tape [N/m], >= 0
    double bulge = 0;                 ///< half-angle of the lobes between the tapes [rad], 0 (smooth) to pi/2
};

/// The equilibrium shape of a hot-air envelope under its load, and the summary of its solution.
struct NaturalShape {
    Meridian meridian;
    double length = 0;      ///< length of the meridian, mouth to crown [m]
    double height = 0;      ///< height, mouth to crown [m]
    double max_radius = 0;  ///< largest radius of the surface; of the tapes if lobed [m]
    double equator_z = 0;   ///< height of the largest radius above the mouth [m]
    double mouth_radius = 0;
    double area = 0;            ///< area of the cloth [m2]
    double volume = 0;          ///< [m3]
    double theta0 = 0;          ///< angle of the cloth from the vertical at the mouth [rad]
    double load = 0;            ///< F: load at the mouth [N]
    double weight = 0;          ///< weight of cloth and tapes [N]
    double mouth_tension = 0;   ///< T at the mouth, whole circle [N]
    double crown_tension = 0;   ///< T at the crown, whole circle [N]
    double crown_pressure = 0;  ///< b H [Pa]
    /// (F + W) / (b V) - 1: rounding for a smooth shape, the model error of the lobes for a lobed one.
    double imbalance = 0;
    SolveSummary summary;

    MeridianPoint point_at(double s) const { return meridian.at(s); }
};

/// Solves `MeridianEquation` with p = 0 at the mouth plane as a boundary value problem: the meridian meets the axis
/// at a right angle (r = 0, th = -90 degrees), the mouth has the given ratio and the envelope the given size.
/// Newton's method on the load, the mouth radius and th0, in the length unit V^(1/3) (or D, or (F/b)^(1/3)). If
/// necessary, weight and lobes are increased from zero by continuation.
///
/// Throws InputError if the options are out of range. If no shape is found, `summary` says failed and the figures are
/// zero: for lobes flatter than about 8 degrees on 24 tapes, lobes on fewer than six tapes (outside the model), or a
/// cloth as heavy as its lift. Takes a few milliseconds; half a second if there is none.
NaturalShape natural_shape(const NaturalShapeOptions& options);

}  // namespace ripstop
