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

/// What an envelope is filled with.
struct LoadCase {
    Air air = {};
    double extra_pressure = 0;               ///< everywhere, beside that of the hot air, such as of a climb [Pa]
    std::optional<double> mouth_plane = {};  ///< height where the gas has no gauge pressure [m]; else the mouth's
};

/// How far an inflated surface is from the drawn one.
struct Deviation {
    double rms = 0, max = 0;  ///< off the drawn surface, along its normal; max with its sign, positive outside [m]
    double moved_rms = 0, moved_max = 0;  ///< of each vertex from its own drawn place [m]
};

/// A tile in flight.
struct InflatedTile {
    Points3 positions;              ///< #V x 3 [m]
    Eigen::VectorXd deviation;      ///< #V: signed distance to the drawn surface [m]
    Points3 strain;                 ///< #F x 3: Green strain E11, E22, 2 E12 from the cloth as cut, warp and weft
    Points3 stress;                 ///< #F x 3: second Piola-Kirchhoff S11, S22, S12 [N/m]
    Points2 tension;                ///< #F x 2: principal true tensions, the larger first [N/m]
    std::vector<ClothState> state;  ///< #F
    Deviation off;
    double tension_max = 0;          ///< largest principal tension [N/m]
    double wrinkled = 0, slack = 0;  ///< shares of its area
};

/// A tape, rope or wire in flight: of one seam, tie or wire.
struct InflatedTape {
    TapeKind kind = TapeKind::load;
    int source = -1;                      ///< as in `SewnTape`
    double force_max = 0, force_min = 0;  ///< along it [N]
    double cut_length = 0;                ///< at rest [m]
    Vec3 worst = Vec3::Zero();            ///< where the force is largest [m]
};

/// How much stronger something is than what it bears, and what is asked.
struct SafetyFactor {
    std::string part;       ///< `cloth`, `load tapes`, `wires`
    double load = 0;        ///< largest in flight; of cloth what all but 0.1 % of it stays below [N/m or N]
    double strength = 0;    ///< new and cold [N/m or N]
    double knock_down = 1;  ///< what of it is counted on: heat, age, seam
    double required = 0;
    double factor = 0;  ///< knock_down strength / (limit load factor x load)
    std::string where = {};
    bool ok() const { return factor >= required; }
};

/// Why an envelope does not take the drawn shape, cause by cause [m, root mean square]. The causes do not add up: one
/// can make good what another does.
struct Causes {
    /// Of pieces cut without error from cloth that does not stretch: gas pressure cannot hold the drawn shape.
    double shape = 0;
    double stretch = 0;   ///< added by the stretch of cloth and tapes and by the foreshortening of the tapes
    double patterns = 0;  ///< added by the pieces as they are cut; not a number if it is not known
};

/// What a round of correcting the patterns came to (`compensate`).
struct CompensationRound {
    std::string step;  ///< `as drawn`, `elastic`, `displacement`
    Deviation off;
    double height = 0, volume = 0;  ///< inflated [m, m3]
    double relaxation = 0;          ///< share of the deviation that was taken back
    bool is_best = false;
};

/// How the inflated shape answers to what is never known well.
struct Sensitivity {
    std::string what;  ///< `cloth 20 % stiffer`
    Deviation off;
    double height = 0, volume = 0;  ///< [m, m3]
};

/// An envelope sewn from its pieces, under gas.
struct Inflated {
    LoadCase load;
    double rise = 0;                ///< b: of the gauge pressure with height [N/m3]
    double floor = 0;               ///< height without gauge pressure [m]
    int sectors = 1;                ///< equal ones, of which one was computed
    double residual_stiffness = 0;  ///< share of the cloth's stiffness left to what is wrinkled
    std::vector<InflatedTile> tiles;
    std::vector<InflatedTape> tapes;
    Deviation off;
    double height = 0, drawn_height = 0, diameter = 0, drawn_diameter = 0;  ///< [m]
    double volume = 0, drawn_volume = 0;                                    ///< [m3]
    double lift = 0;                       ///< what it carries beside itself: the pull on what holds it [N]
    double cloth_mass = 0, tape_mass = 0;  ///< [kg]
    double crown_pressure = 0;             ///< at the highest point [Pa]
    double tension_max = 0;                ///< [N/m]
    std::string tension_tile;              ///< where
    double load_tape_max = 0;              ///< [N]
    double wrinkled = 0, slack = 0;        ///< shares of the area of the cloth
    double seam_gap = 0;                   ///< largest distance between two sides of a seam as drawn [m]
    double imbalance = 0;                  ///< lift / (b V - W + extra) - 1
    double force_residual = 0;             ///< root mean square, in pressure times edge squared
    bool is_stable = false;
    std::vector<SafetyFactor> safety;
    std::optional<Causes> causes = {};
    std::vector<CompensationRound> rounds = {};  ///< where the patterns were corrected
    std::vector<Sensitivity> sensitivity = {};
    SolveSummary summary;
    double seconds = 0;

    bool stands() const;   ///< the gas carries the cloth: neither its volume is lost nor its lift
    bool is_safe() const;  ///< it stands, and everything that was judged is strong enough
};

}  // namespace ripstop
