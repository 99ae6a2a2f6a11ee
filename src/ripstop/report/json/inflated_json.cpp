#include "ripstop/report/json/inflated_json.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/report/figures/json_figures.h"
#include "ripstop/report/words/inflated_says.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

/// The ranges of strain and stress of the threads, and of the shear angle.
struct ClothRange {
    double warp_min = 0, warp_max = 0, weft_min = 0, weft_max = 0, shear = 0;  ///< strains [1, rad]
    double warp_stress = 0, weft_stress = 0, shear_stress = 0;                 ///< [N/m]

    void take(const InflatedTile& tile) {
        for (Eigen::Index t = 0; t < tile.strain.rows(); ++t) {
            const double warp = std::sqrt(1 + 2 * tile.strain(t, 0)), weft = std::sqrt(1 + 2 * tile.strain(t, 1));
            warp_min = std::min(warp_min, warp - 1);
            warp_max = std::max(warp_max, warp - 1);
            weft_min = std::min(weft_min, weft - 1);
            weft_max = std::max(weft_max, weft - 1);
            shear = std::max(shear, std::abs(std::asin(std::clamp(tile.strain(t, 2) / (warp * weft), -1.0, 1.0))));
        }
        if (tile.stress.rows() == 0) return;
        warp_stress = std::max(warp_stress, tile.stress.col(0).maxCoeff());
        weft_stress = std::max(weft_stress, tile.stress.col(1).maxCoeff());
        shear_stress = std::max(shear_stress, tile.stress.col(2).cwiseAbs().maxCoeff());
    }

    void write(Json& json) const {
        json["strain"] = {{"warp_min_pct", in_percent(warp_min)},
                          {"warp_max_pct", in_percent(warp_max)},
                          {"weft_min_pct", in_percent(weft_min)},
                          {"weft_max_pct", in_percent(weft_max)},
                          {"shear_max_deg", in_degrees(shear)}};
        json["stress"] = {{"warp_max_n_per_m", figure(warp_stress)},
                          {"weft_max_n_per_m", figure(weft_stress)},
                          {"shear_max_n_per_m", figure(shear_stress)}};
    }
};

Json deviation_json(const Deviation& off) {
    return {{"deviation_rms_mm", in_millimetres(off.rms)},
            {"deviation_max_mm", in_millimetres(off.max)},
            {"moved_rms_mm", in_millimetres(off.moved_rms)},
            {"moved_max_mm", in_millimetres(off.moved_max)}};
}

Json load_json(const Inflated& inflated) {
    const LoadCase& load = inflated.load;
    return {{"inside_c", figure(load.air.inside)},
            {"outside_c", figure(load.air.outside)},
            {"altitude_m", figure(load.air.altitude)},
            {"extra_pressure_pa", figure(load.extra_pressure)},
            {"no_pressure_at_mm", in_millimetres(inflated.floor)},
            {"no_pressure_is_given", load.mouth_plane.has_value()},
            {"pressure_rise_pa_per_m", figure(inflated.rise)},
            {"crown_pressure_pa", figure(inflated.crown_pressure)}};
}

Json safety_json(const std::vector<SafetyFactor>& factors) {
    Json list = Json::array();
    for (const SafetyFactor& each : factors) {
        const std::string unit = each.part == "cloth" ? "_n_per_m" : "_n";
        list.push_back({{"part", each.part},
                        {"where", each.where},
                        {"load" + unit, figure(each.load)},
                        {"strength" + unit, figure(each.strength)},
                        {"knock_down", figure(each.knock_down)},
                        {"factor", figure(each.factor)},
                        {"required", figure(each.required)},
                        {"ok", each.ok()}});
    }
    return list;
}

Json tapes_json(const CutPlan& plan) {
    Json list = Json::array();
    for (const InflatedTape& tape : plan.inflated->tapes) {
        Json json = {{"kind", tape.kind == TapeKind::load ? "load" : tape.kind == TapeKind::wire ? "wire" : "tie"}};
        if (tape.kind == TapeKind::load)
            json["seam"] = plan.seams[at(tape.source)].id;
        else
            json["number"] = tape.source + 1;
        json["force_min_n"] = figure(tape.force_min);
        json["force_max_n"] = figure(tape.force_max);
        json["force_max_at_mm"] = point_json(tape.worst);
        json["cut_length_mm"] = in_millimetres(tape.cut_length);
        list.push_back(json);
    }
    return list;
}

Json rounds_json(const std::vector<CompensationRound>& rounds) {
    Json list = Json::array();
    for (const CompensationRound& round : rounds) {
        Json json = {{"step", round.step}};
        json.update(deviation_json(round.off));
        json["height_mm"] = in_millimetres(round.height);
        json["volume_m3"] = figure(round.volume);
        json["relaxation"] = figure(round.relaxation);
        json["best"] = round.is_best;
        list.push_back(json);
    }
    return list;
}

Json sensitivity_json(const std::vector<Sensitivity>& sensitivity) {
    Json list = Json::array();
    for (const Sensitivity& each : sensitivity) {
        Json json = {{"what", each.what}};
        json.update(deviation_json(each.off));
        json["height_mm"] = in_millimetres(each.height);
        json["volume_m3"] = figure(each.volume);
        list.push_back(json);
    }
    return list;
}

/// The keys that the contract promises, in its order.
Json promised_json(const Inflated& inflated, bool reproducible) {
    double least = std::numeric_limits<double>::infinity();
    for (const SafetyFactor& each : inflated.safety) least = std::min(least, each.factor);
    Json json = {{"deviation_rms_mm", in_millimetres(inflated.off.rms)},
                 {"deviation_max_mm", in_millimetres(inflated.off.max)},
                 {"height_mm", in_millimetres(inflated.height)},
                 {"drawn_height_mm", in_millimetres(inflated.drawn_height)},
                 {"volume_m3", figure(inflated.volume)},
                 {"drawn_volume_m3", figure(inflated.drawn_volume)},
                 {"lift_n", figure(inflated.lift)},
                 {"stress_max_n_per_m", figure(inflated.tension_max)},
                 {"tape_force_max_n", figure(inflated.load_tape_max)},
                 {"wrinkled_pct", in_percent(inflated.wrinkled)},
                 {"safety_factor", figure(least)},
                 {"converged", inflated.summary.termination == Termination::converged},
                 {"iterations", inflated.summary.iterations}};
    if (!reproducible) json["seconds"] = figure(inflated.seconds);
    return json;
}

void add_sizes(Json& json, const Inflated& inflated) {
    json["deviation_limit_mm"] = in_millimetres(deviation_limit(inflated));
    json["moved_rms_mm"] = in_millimetres(inflated.off.moved_rms);
    json["moved_max_mm"] = in_millimetres(inflated.off.moved_max);
    json["diameter_mm"] = in_millimetres(inflated.diameter);
    json["drawn_diameter_mm"] = in_millimetres(inflated.drawn_diameter);
    json["cloth_mass_kg"] = figure(inflated.cloth_mass);
    json["tape_mass_kg"] = figure(inflated.tape_mass);
    json["stress_max_tile"] = inflated.tension_tile;
    json["slack_pct"] = in_percent(inflated.slack);
}

/// How the solution was found, and how reliable it is.
void add_solution(Json& json, const Inflated& inflated) {
    json["sectors"] = inflated.sectors;
    json["residual_stiffness"] = figure(inflated.residual_stiffness);
    json["seam_gap_mm"] = in_millimetres(inflated.seam_gap);
    json["imbalance_pct"] = in_percent(inflated.imbalance);
    json["force_residual"] = figure(inflated.force_residual);
    json["stable"] = inflated.is_stable;
    json["factorizations"] = inflated.summary.factorizations;
    json["stop"] = name(inflated.summary.termination);
    json["stop_reason"] = inflated.summary.reason;
}

}  // namespace

Json inflated_json(const CutPlan& plan, bool reproducible) {
    const Inflated& inflated = *plan.inflated;
    Json json = promised_json(inflated, reproducible);
    json["says"] = inflated_says(plan);
    json["safe"] = inflated.is_safe();
    add_sizes(json, inflated);
    json["load"] = load_json(inflated);
    ClothRange range;
    for (const InflatedTile& tile : inflated.tiles) range.take(tile);
    range.write(json);
    json["safety"] = safety_json(inflated.safety);
    if (inflated.causes)
        json["causes"] = {{"shape_mm", in_millimetres(inflated.causes->shape)},
                          {"stretch_mm", in_millimetres(inflated.causes->stretch)},
                          {"patterns_mm", in_millimetres(inflated.causes->patterns)}};
    json["compensated"] = is_corrected(plan);
    json["tapes"] = tapes_json(plan);
    json["rounds"] = rounds_json(plan.rounds);
    json["sensitivity"] = sensitivity_json(inflated.sensitivity);
    add_solution(json, inflated);
    return json;
}

Json inflated_tile_json(const InflatedTile& tile) {
    Json json = deviation_json(tile.off);
    json["stress_max_n_per_m"] = figure(tile.tension_max);
    json["wrinkled_pct"] = in_percent(tile.wrinkled);
    json["slack_pct"] = in_percent(tile.slack);
    ClothRange range;
    range.take(tile);
    range.write(json);
    return json;
}

}  // namespace ripstop
