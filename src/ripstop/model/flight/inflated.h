#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/solve_summary.h"
#include "ripstop/geometry/types.h"
#include "ripstop/model/flight/air.h"
#include "ripstop/model/flight/cloth_state.h"
#include "ripstop/model/flight/sewn_envelope.h"

namespace ripstop {

/// The pressure that acts on an envelope.
struct LoadCase {
    Air air = {};
    double extra_pressure = 0;               ///< added gauge pressure, equal everywhere, such as of a climb [Pa]
    std::optional<double> mouth_plane = {};  ///< height at which the gauge pressure is zero [m]; by default that of the
                                             ///< mouth
};

/// The deviation of an inflated surface from the drawn one.
struct Deviation {
    double rms = 0, max = 0;  ///< distance from the drawn surface along its normal; max is signed, positive outside [m]
    double moved_rms = 0, moved_max = 0;  ///< distance of each vertex from its own drawn place [m]
};

/// A tile in flight.
struct InflatedTile {
    Points3 positions;          ///< #V x 3 [m]
    Eigen::VectorXd deviation;  ///< #V: signed distance to the drawn surface [m]
    Points3 strain;             ///< #F x 3: Green strain E11, E22, 2 E12 relative to the cloth as cut, in warp and weft
    Points3 stress;             ///< #F x 3: second Piola-Kirchhoff S11, S22, S12 [N/m]
    Points2 tension;            ///< #F x 2: principal Cauchy tensions, the larger first [N/m]
    std::vector<ClothState> state;  ///< #F
    Deviation off;
    double tension_max = 0;          ///< largest principal tension [N/m]
    double wrinkled = 0, slack = 0;  ///< fractions of its area
};

/// A tape, rope or wire in flight; it belongs to one seam, tie or wire.
struct InflatedTape {
    TapeKind kind = TapeKind::load;
    int source = -1;                      ///< as in `SewnTape`
    double force_max = 0, force_min = 0;  ///< largest and smallest tension along it [N]
    double cut_length = 0;                ///< length at rest [m]
    Vec3 worst = Vec3::Zero();            ///< place of the largest force [m]
};

/// The safety factor of a part, and the one that is required.
struct SafetyFactor {
    std::string part;       ///< `cloth`, `load tapes`, `wires`
    double load = 0;        ///< largest load in flight; for cloth the 99.9th percentile by area [N/m or N]
    double strength = 0;    ///< strength when new and cold [N/m or N]
    double knock_down = 1;  ///< fraction of the strength that heat, age and the seam leave
    double required = 0;
    double factor = 0;  ///< knock_down strength / (limit load factor x load)
    std::string where = {};
    bool ok() const { return factor >= required; }
};

/// The causes of the deviation from the drawn shape [m, root mean square]. They do not add up: one can offset
/// another.
struct Causes {
    /// with pieces cut without error from cloth that does not stretch: gas pressure cannot hold the drawn shape
    double shape = 0;
    double stretch = 0;   ///< added by the stretch of cloth and tapes and by the foreshortening of the tapes
    double patterns = 0;  ///< added by the pieces as cut; NaN if unknown
};

/// The result of one round of pattern compensation (`compensate`).
struct CompensationRound {
    std::string step;  ///< `as drawn`, `elastic`, `displacement`
    Deviation off;
    double height = 0, volume = 0;  ///< as inflated [m, m3]
    double relaxation = 0;          ///< fraction of the deviation that was compensated
    bool is_best = false;
};

/// The change of the inflated shape when an uncertain property changes.
struct Sensitivity {
    std::string what;  ///< `cloth 20 % stiffer`
    Deviation off;
    double height = 0, volume = 0;  ///< [m, m3]
};

/// The result of an inflation: an envelope sewn from its pieces, under gas.
struct Inflated {
    LoadCase load;
    double rise = 0;                ///< b: gradient of the gauge pressure with height [N/m3]
    double floor = 0;               ///< height at which the gauge pressure is zero [m]
    int sectors = 1;                ///< equal sectors of the envelope, one of which was computed
    double residual_stiffness = 0;  ///< fraction of its stiffness that wrinkled cloth keeps
    std::vector<InflatedTile> tiles;
    std::vector<InflatedTape> tapes;
    Deviation off;
    double height = 0, drawn_height = 0, diameter = 0, drawn_diameter = 0;  ///< [m]
    double volume = 0, drawn_volume = 0;                                    ///< [m3]
    double lift = 0;  ///< net lift: the force on whatever holds the envelope, its own weight deducted [N]
    double cloth_mass = 0, tape_mass = 0;  ///< [kg]
    double crown_pressure = 0;             ///< gauge pressure at the highest point [Pa]
    double tension_max = 0;                ///< [N/m]
    std::string tension_tile;              ///< tile with that tension
    double load_tape_max = 0;              ///< [N]
    double wrinkled = 0, slack = 0;        ///< fractions of the cloth's area
    double seam_gap = 0;                   ///< largest distance between two sides of a seam as drawn [m]
    double imbalance = 0;                  ///< lift / (b V - W + extra) - 1
    double force_residual = 0;             ///< root mean square, relative to pressure times edge squared
    bool is_stable = false;
    std::vector<SafetyFactor> safety;
    std::optional<Causes> causes = {};
    std::vector<Sensitivity> sensitivity = {};
    SolveSummary summary;
    double seconds = 0;

    bool stands() const;   ///< the gas carries the cloth: it has lost neither its volume nor its lift
    bool is_safe() const;  ///< it stands, and every part that was checked is strong enough
};

}  // namespace ripstop
