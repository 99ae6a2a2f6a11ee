#include "ripstop/report/json/report_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ripstop/base/index.h"
#include "ripstop/base/text/units.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/report/figures/json_figures.h"
#include "ripstop/report/figures/load_tapes.h"
#include "ripstop/report/json/inflated_json.h"
#include "ripstop/report/json/says_json.h"
#include "ripstop/report/tables/seam_tables.h"
#include "ripstop/tile/allowance.h"
#include "ripstop/version.h"

namespace ripstop {
namespace {

using Json = nlohmann::ordered_json;

Json fabric_json(const Fabric& fabric) {
    return {{"name", fabric.name},
            {"description", fabric.description},
            {"warp_stiffness_n_per_m", figure(fabric.warp_stiffness)},
            {"weft_stiffness_n_per_m", figure(fabric.weft_stiffness)},
            {"shear_stiffness_n_per_m", figure(fabric.shear_stiffness)},
            {"poisson", figure(fabric.poisson)},
            {"mass_kg_per_m2", figure(fabric.mass)},
            {"strength_n_per_m", figure(fabric.strength)},
            {"roll_width_mm", in_millimetres(fabric.roll_width)},
            {"strain_limit_pct", in_percent(fabric.strain_limit)},
            {"shear_limit_deg", in_degrees(fabric.shear_limit)}};
}

/// All fabrics that are cut, with their amounts.
Json fabrics_json(const CutPlan& plan) {
    Json list = Json::array();
    for (const Fabric& fabric : plan.fabrics()) {
        int tiles = 0;
        double area = 0;
        for (const FlatTile& tile : plan.tiles) {
            if (!(plan.fabric_of(tile.tile) == fabric)) continue;
            ++tiles;
            area += tile.accuracy.area;
        }
        list.push_back(fabric_json(fabric));
        list.back()["tiles"] = tiles;
        list.back()["area_m2"] = figure(area);
    }
    return list;
}

Json seam_types_json(const CutPlan& plan) {
    Json list = Json::array();
    for (const SeamTypeUse& use : seam_types_used(plan))
        list.push_back({{"type", use.type.name},
                        {"allowance_mm", in_millimetres(use.type.allowance)},
                        {"rows", use.type.rows},
                        {"tape", use.type.tape},
                        {"seams", use.seams},
                        {"free_edges", use.free_edges},
                        {"length_mm", in_millimetres(use.length)}});
    return list;
}

/// Adds the smallest, mean (by length) and largest tension of each chain's edges [N].
void add_tension(Json& chains, const FlatTile& tile) {
    if (tile.flattening.seam_tension.size() == 0) return;
    std::vector<Eigen::Index> place(static_cast<std::size_t>(tile.tile.mesh.vertex_count()));
    for (std::size_t i = 0; i < tile.tile.boundary.size(); ++i)
        place[at(tile.tile.boundary[i])] = static_cast<Eigen::Index>(i);
    for (std::size_t c = 0; c < tile.tile.chains.size(); ++c) {
        const Chain& chain = tile.tile.chains[c];
        const Eigen::VectorXd lengths = edge_lengths(tile.tile.mesh.positions, chain.vertices);
        Eigen::VectorXd tension(chain.edge_count());
        for (int i = 0; i < chain.edge_count(); ++i)
            tension[i] = tile.flattening.seam_tension[place[at(chain.vertices[at(i)])]];
        chains[c]["tension_n"] = {{"min", figure(tension.minCoeff())},
                                  {"mean", figure(tension.dot(lengths) / lengths.sum())},
                                  {"max", figure(tension.maxCoeff())}};
    }
}

/// Adds the seams of each chain: the first along it, and all if there are several.
void add_seams(Json& chains, const std::vector<std::vector<int>>& sewn, const CutPlan& plan) {
    for (std::size_t c = 0; c < std::min(chains.size(), sewn.size()); ++c) {
        Json ids = Json::array();
        for (const int seam : sewn[c]) ids.push_back(plan.seams[at(seam)].id);
        if (!ids.empty()) chains[c]["seam"] = ids.front();
        if (ids.size() > 1) chains[c]["seams"] = ids;
    }
}

/// Adds the finish of the parts of chains that are in no seam.
void add_finishes(Json& chains, const Tile& tile, const Eigen::VectorXd& left) {
    for (std::size_t c = 0; c < std::min(chains.size(), tile.chains.size()); ++c) {
        const double length = left[static_cast<Eigen::Index>(c)];
        if (!(length > 0)) continue;
        chains[c]["free_mm"] = in_millimetres(length);
        chains[c]["type"] = tile.chains[c].finish.name;
        chains[c]["allowance_mm"] = in_millimetres(tile.chains[c].finish.allowance);
    }
}

Json chains_json(const FlatTile& tile) {
    Json chains = Json::array();
    for (const ChainAccuracy& chain : tile.accuracy.chains)
        chains.push_back({{"length_mm", in_millimetres(chain.length)},
                          {"flat_length_mm", in_millimetres(chain.flat_length)},
                          {"error_mm", in_millimetres(chain.flat_length - chain.length)},
                          {"error_pct", in_percent(chain.error())},
                          {"seam", nullptr}});
    add_tension(chains, tile);
    return chains;
}

Json certificate_json(const Certificate& certificate) {
    return {{"force_residual", figure(certificate.force_residual)},
            {"length_residual", figure(certificate.length_residual)},
            {"strict_minimum", certificate.strict_minimum}};
}

Json findings_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& finding : findings)
        list.push_back({{"code", finding.code},
                        {"message", finding.message},
                        {"at_mm", point_json(finding.at)},
                        {"value", figure(finding.value)},
                        {"limit", figure(finding.limit)}});
    return list;
}

Json verdict_json(const Verdict& verdict) {
    Json json = {{"manufacturable", verdict.manufacturable()}, {"findings", findings_json(verdict.findings)}};
    if (!verdict.waived.empty()) json["waived"] = findings_json(verdict.waived);
    return json;
}

Json seam_json(const Seam& seam, const SeamWalk& walk, const CutPlan& plan) {
    const auto tile = [&](const SeamSide& side) { return plan.tiles[at(side.tile)].tile.name; };
    Json notches = Json::array();
    for (const MatchMark& notch : walk.notches)
        notches.push_back({{"at_mm", in_millimetres(notch.at)}, {"drift_mm", in_millimetres(notch.drift)}});
    return {{"id", seam.id},
            {"tile_a", tile(seam.a)},
            {"chain_a", seam.a.chain + 1},
            {"tile_b", tile(seam.b)},
            {"chain_b", seam.b.chain + 1},
            {"length_mm", in_millimetres(walk.length)},
            {"flat_a_mm", in_millimetres(walk.flat_a)},
            {"flat_b_mm", in_millimetres(walk.flat_b)},
            {"mismatch_mm", in_millimetres(walk.mismatch())},
            {"mismatch_pct", in_percent(walk.mismatch_ratio())},
            {"drift_max_mm", in_millimetres(walk.drift_max)},
            {"drift_max_at_mm", in_millimetres(walk.drift_max_at)},
            {"limit_mm", in_millimetres(walk.limit)},
            {"uncertainty_mm", in_millimetres(walk.uncertainty)},
            {"gap_mm", in_millimetres(seam.gap)},
            {"type", seam.type.name},
            {"allowance_a_mm", in_millimetres(seam.allowance(seam.a))},
            {"allowance_b_mm", in_millimetres(seam.allowance(seam.b))},
            {"notches", notches},
            {"certain", walk.is_certain()},
            {"ok", walk.ok}};
}

/// Adds the records of seams of three or more sheets: which lies in which.
void add_further_sheets(Json& seams, const CutPlan& plan) {
    for (std::size_t i = 0; i < plan.seams.size(); ++i) {
        if (!plan.seams[i].into) continue;
        const auto skin = static_cast<std::size_t>(plan.seams[i].into->seam);
        seams[i]["sewn_into"] = plan.seams[skin].id;
        seams[i]["sewn_into_from_mm"] = in_millimetres(plan.seams[i].into->from);
        seams[skin]["further_tiles"].push_back(plan.tiles[at(plan.seams[i].a.tile)].tile.name);
    }
}

Json strain_json(const Accuracy& accuracy) {
    return {{"warp_min_pct", in_percent(accuracy.warp_strain_min)},
            {"warp_max_pct", in_percent(accuracy.warp_strain_max)},
            {"weft_min_pct", in_percent(accuracy.weft_strain_min)},
            {"weft_max_pct", in_percent(accuracy.weft_strain_max)},
            {"shear_max_deg", in_degrees(accuracy.shear_max)}};
}

Json trial_json(const Trial& trial) {
    const Accuracy& accuracy = trial.accuracy;
    return {{"triangles", trial.triangles},
            {"area_m2", figure(accuracy.area)},
            {"area_error_pct", in_percent(accuracy.area_error)},
            {"perimeter_error_pct", in_percent(accuracy.perimeter_error)},
            {"chain_error_max_pct", in_percent(worst_chain_error(accuracy))},
            {"strain", strain_json(accuracy)},
            {"energy_j", figure(accuracy.energy)},
            {"verdict", verdict_json(trial.verdict)}};
}

Json proposal_json(const SplitProposal& proposal) {
    Json line = Json::array(), halves = Json::array();
    for (const Vec3& at : proposal.line) line.push_back(point_json(at));
    for (const Trial& half : proposal.halves) halves.push_back(trial_json(half));
    return {{"direction", proposal.direction},
            {"from_mm", line.front()},
            {"to_mm", line.back()},
            {"line_mm", line},
            {"lines_tried", proposal.tried},
            {"findings_before", proposal.findings_before},
            {"halves", halves}};
}

Json merges_json(const CutPlan& plan) {
    Json merges = Json::array();
    for (const MergeProposal& merge : plan.merges) {
        Json json = {{"tile_a", plan.tiles[at(merge.tile_a)].tile.name},
                     {"tile_b", plan.tiles[at(merge.tile_b)].tile.name},
                     {"seam", plan.seams[at(merge.seam)].id}};
        json.update(trial_json(merge.merged));
        merges.push_back(json);
    }
    return merges;
}

Json envelope_json(const CutPlan& plan) {
    Json failed = Json::array(), failed_seams = Json::array();
    for (const FlatTile& tile : plan.tiles)
        if (!tile.verdict.manufacturable()) failed.push_back(tile.tile.name);
    for (const Finding& finding : plan.findings)
        for (const std::string& name : finding.code == "no_tile" ? finding.tiles : std::vector<std::string>())
            failed.push_back(name);
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        if (!plan.walks[i].ok) failed_seams.push_back(plan.seams[i].id);
    return {{"tiles", plan.tiles.size()},
            {"seams", plan.seams.size()},
            {"area_m2", figure(plan.area())},
            {"manufacturable", plan.manufacturable()},
            {"failed", failed},
            {"failed_seams", failed_seams},
            {"findings", findings_json(plan.findings)},
            {"warnings", plan.warnings},
            {"says", says_json(plan)},
            {"merges", merges_json(plan)}};
}

void add_accuracy(Json& json, const Accuracy& accuracy) {
    json["area_m2"] = figure(accuracy.area);
    json["flat_area_m2"] = figure(accuracy.flat_area);
    json["area_error_pct"] = in_percent(accuracy.area_error);
    json["area_error_abs_pct"] = in_percent(accuracy.area_error_abs);
    json["perimeter_mm"] = in_millimetres(accuracy.perimeter);
    json["perimeter_error_pct"] = in_percent(accuracy.perimeter_error);
    json["edge_error_abs_pct"] = in_percent(accuracy.edge_error_abs);
    json["boundary_error_abs_pct"] = in_percent(accuracy.boundary_error_abs);
    json["boundary_error_max_pct"] = in_percent(accuracy.boundary_error_max);
    json["strain"] = strain_json(accuracy);
    json["energy_j"] = figure(accuracy.energy);
    json["flipped"] = accuracy.flipped;
    json["overlaps"] = accuracy.overlaps;
}

/// A new mesh compared with the input's: what was drawn, and how the piece differs from it.
Json remeshed_json(const Remeshed& remeshed, const Accuracy& accuracy) {
    return {{"reason", remeshed.reason},
            {"triangles_before", remeshed.triangles_before},
            {"edge_length_mm", in_millimetres(remeshed.edge_length)},
            {"turn_max_deg", in_degrees(remeshed.turn_max)},
            {"distance_max_mm", in_millimetres(remeshed.distance_max)},
            {"area_before_m2", figure(remeshed.area_before)},
            {"area_change_pct", in_percent(accuracy.area / remeshed.area_before - 1)},
            {"flat_area_change_pct", in_percent(accuracy.flat_area / remeshed.area_before - 1)},
            {"perimeter_before_mm", in_millimetres(remeshed.perimeter_before)},
            {"perimeter_change_pct", in_percent(accuracy.perimeter / remeshed.perimeter_before - 1)}};
}

/// The lengthening of a piece that does not come from flight: shrinkage of the cloth, take-up of the seams.
Json compensation_json(const Compensation& longer) {
    Json chains = Json::array();
    for (const double chain : longer.chains) chains.push_back(in_percent(chain));
    return {{"warp_pct", in_percent(longer.warp)}, {"weft_pct", in_percent(longer.weft)}, {"take_up_pct", chains}};
}

Json tile_json(const FlatTile& tile, const std::string& stem, const Json& chains, bool reproducible) {
    const SolveSummary& summary = tile.flattening.summary;
    const Vec3& warp = tile.tile.grain.direction;
    Json json = {
        {"name", tile.tile.name},
        {"file", stem},
        {"vertices", tile.tile.mesh.vertex_count()},
        {"triangles", tile.tile.mesh.triangle_count()},
        {"grain",
         {{"direction", {figure(warp.x()), figure(warp.y()), figure(warp.z())}}, {"source", tile.tile.grain.source}}},
        {"method", tile.method}};
    const Compensation& longer = tile.tile.compensation;
    if (longer.warp != 0 || longer.weft != 0 || !longer.chains.empty())
        json["compensation"] = compensation_json(longer);
    if (tile.tile.remeshed) json["remeshed"] = remeshed_json(*tile.tile.remeshed, tile.accuracy);
    if (!reproducible && std::isfinite(tile.seconds)) json["seconds"] = figure(tile.seconds);
    json["iterations"] = summary.iterations;
    json["factorizations"] = summary.factorizations;
    json["stop"] = name(summary.termination);
    json["stop_reason"] = summary.reason;
    if (!tile.flattening.note.empty()) json["note"] = tile.flattening.note;
    json["bounds"] = {{"isoperimetric", figure(tile.bounds.isoperimetric)},
                      {"stretch_ratio_min", figure(tile.bounds.stretch_ratio)},
                      {"disc_radius_mm", in_millimetres(tile.bounds.radius)}};
    if (tile.flattening.certificate) json["certificate"] = certificate_json(*tile.flattening.certificate);
    add_accuracy(json, tile.accuracy);
    json["chains"] = chains;
    json["verdict"] = verdict_json(tile.verdict);
    if (tile.proposal) json["proposal"] = proposal_json(*tile.proposal);
    return json;
}

void add_quantity(Json& json, const CutPlan& plan, std::size_t i, const Quantity& cut) {
    const FlatTile& tile = plan.tiles[i];
    if (tile.equal_to >= 0) json[tile.mirrored ? "mirror_of" : "equal_to"] = plan.tiles[at(tile.equal_to)].tile.name;
    json["quantity"] = cut.same;
    json["quantity_mirrored"] = cut.mirrored;
}

}  // namespace

std::string report_json(const CutPlan& plan, bool reproducible) {
    Json tiles = Json::array(), seams = Json::array();
    const auto sewn = seams_of_chains(plan);
    const std::vector<std::string> stems = file_stems(plan);
    const std::vector<Quantity> cut = quantities(plan);
    const std::vector<Eigen::VectorXd> left = free_lengths(plan);
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        Json chains = chains_json(plan.tiles[i]);
        add_seams(chains, sewn[i], plan);
        add_finishes(chains, plan.tiles[i].tile, left[i]);
        tiles.push_back(tile_json(plan.tiles[i], stems[i], chains, reproducible));
        tiles.back()["fabric"] = plan.fabric_of(plan.tiles[i].tile).name;
        add_quantity(tiles.back(), plan, i, cut[i]);
        if (plan.inflated) tiles.back()["inflated"] = inflated_tile_json(plan.inflated->tiles[i]);
    }
    const std::vector<double> cut_lengths = tape_cut_lengths(plan);
    const std::vector<int> tapes = plan.inflated ? tapes_of_seams(plan) : std::vector<int>(plan.seams.size(), -1);
    for (std::size_t i = 0; i < plan.walks.size(); ++i) {
        seams.push_back(seam_json(plan.seams[i], plan.walks[i], plan));
        if (std::isfinite(cut_lengths[i])) seams.back()["tape_cut_mm"] = in_millimetres(cut_lengths[i]);
        if (tapes[i] >= 0) seams.back()["tape_force_max_n"] = figure(plan.inflated->tapes[at(tapes[i])].force_max);
    }
    add_further_sheets(seams, plan);
    Json report = {
        {"ripstop", version},
        {"schema", report_schema},
        {"input",
         {{"file", plan.input_file}, {"sha256", plan.input_sha256}, {"unit", plan.unit}, {"remarks", plan.remarks}}},
        {"fabric", fabric_json(plan.fabric)},
        {"fabrics", fabrics_json(plan)},
        {"tolerances",
         {{"area_pct", in_percent(plan.tolerances.area)},
          {"length_pct", in_percent(plan.tolerances.length)},
          {"strain_pct", in_percent(plan.tolerances.strain)},
          {"shear_deg", in_degrees(plan.tolerances.shear)}}},
        {"tiles", tiles},
        {"seams", seams},
        {"seam_types", seam_types_json(plan)},
        {"envelope", envelope_json(plan)}};
    if (plan.inflated) report["inflated"] = inflated_json(plan, reproducible);
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ripstop
