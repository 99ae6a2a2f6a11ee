#pragma once

#include <optional>

#include "ripstop/base/solve_summary.h"
#include "ripstop/design/natural/meridian.h"
#include "ripstop/model/flight/air.h"

namespace ripstop {

/// One size is given: the diameter if any, else the load if any, else the volume.
struct NaturalShapeOptions {
    double volume = 3000;             ///< [m3], > 0
    std::optional<double> diameter;   ///< twice the largest radius (of the tapes, where lobed) [m], > 0
    std::optional<double> load;       ///< hanging from the mouth [N], > 0
    double mouth_ratio = 0.26;        ///< radius of the mouth over the largest, [0, 0.8]; 0: closed to a point
    double buoyancy = 2.7365;         ///< b [N/m3], > 0
    double weight = 0.065 * gravity;  ///< of the cloth [N/m2], >= 0
    int tapes = 24;                   ///< 3 to 1000
    double tape_weight = 0;           ///< of one tape [N/m], >= 0
    double bulge = 0;                 ///< half-angle of the lobes between the tapes [rad], 0 (smooth) to pi/2
};

/// The equilibrium shape of a hot-air envelope under its load, and how it was found.
struct NaturalShape {
    Meridian meridian;
    double length = 0;      ///< of the meridian, mouth to crown [m]
    double height = 0;      ///< mouth to crown [m]
    double max_radius = 0;  ///< of the surface; of the tapes, where lobed [m]
    double equator_z = 0;   ///< its height above the mouth [m]
    double mouth_radius = 0;
    double area = 0;            ///< of the cloth [m2]
    double volume = 0;          ///< [m3]
    double theta0 = 0;          ///< angle of the cloth from the vertical at the mouth [rad]
    double load = 0;            ///< F, hanging from the mouth [N]
    double weight = 0;          ///< of cloth and tapes [N]
    double mouth_tension = 0;   ///< T at the mouth, all round [N]
    double crown_tension = 0;   ///< T at the crown, all round [N]
    double crown_pressure = 0;  ///< b H [Pa]
    /// (F + W) / (b V) - 1: round-off for a smooth shape, the lobe model's own error for a lobed one.
    double imbalance = 0;
    SolveSummary summary;

    MeridianPoint point_at(double s) const { return meridian.at(s); }
};

/// Solves `MeridianEquation` with p = 0 at the mouth plane so that the meridian meets the axis square (r = 0, th = -90
/// degrees), the mouth has the wanted ratio and the envelope the wanted size: Newton's method on the load, the mouth's
/// radius and th0, in the length unit V^(1/3) (or D, or (F/b)^(1/3)), following the weight and the lobes up from
/// nothing where it must.
///
/// Throws InputError for options out of range. Where no such shape is found `summary` says failed and the figures are
/// zero: lobes flatter than about 8 degrees on 24 tapes, lobes on fewer than six tapes (beyond the model), a cloth as
/// heavy as its lift. A few milliseconds; half a second to find none.
NaturalShape natural_shape(const NaturalShapeOptions& options);

}  // namespace ripstop
