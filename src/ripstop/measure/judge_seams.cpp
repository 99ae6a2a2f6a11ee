#include "ripstop/measure/judge_seams.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/corner_turn.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

/// The sewn part of each chain of a tile.
struct Mating {
    double sewn = 0;  ///< length on the curves of its seams [m]
    bool agrees = true;
};

std::string in_mm(double length, int decimals) {
    return format_fixed(length / millimetre, decimals) + " mm";
}

std::string message(const Seam& seam, const SeamWalk& walk, const CutPlan& plan) {
    const auto name = [&](const SeamSide& side) { return plan.tiles[at(side.tile)].tile.name; };
    const std::string open =
        walk.uncertainty > 0 ? "; the meshes leave " + in_mm(walk.uncertainty, 2) + " uncertain" : std::string();
    if (!std::isfinite(walk.drift_max)) return "seam " + seam.id + " has a side that was not flattened";
    if (!(std::abs(walk.mismatch()) <= walk.limit))
        return "seam " + seam.id + ", " + in_mm(walk.length, 0) + " long: the edge of " + name(seam.b) + " is " +
               in_mm(std::abs(walk.mismatch()), 2) + (walk.mismatch() > 0 ? " longer" : " shorter") +
               " than the edge of " + name(seam.a) + " that it is sewn to" + open;
    return "seam " + seam.id + ": the edges of " + name(seam.a) + " and " + name(seam.b) + " are " +
           in_mm(walk.drift_max, 2) + " apart after " + in_mm(walk.drift_max_at, 0) + ", though they end together" +
           open;
}

std::vector<std::vector<Mating>> mate(const CutPlan& plan) {
    std::vector<std::vector<Mating>> mates;
    for (const FlatTile& tile : plan.tiles) mates.emplace_back(tile.tile.chains.size());
    for (std::size_t i = 0; i < plan.seams.size(); ++i)
        for (const SeamSide* side : {&plan.seams[i].a, &plan.seams[i].b}) {
            Mating& here = mates[at(side->tile)][at(side->chain)];
            if (!plan.seams[i].into || side == &plan.seams[i].a) here.sewn += plan.seams[i].length;
            here.agrees = here.agrees && plan.walks[i].ok;
        }
    return mates;
}

/// The drawn length of each chain [m].
std::vector<double> chain_lengths(const Tile& tile) {
    const Eigen::VectorXd drawn = drawn_lengths(tile);
    std::vector<double> leaving(static_cast<std::size_t>(tile.mesh.vertex_count()), 0), lengths;
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        leaving[at(tile.boundary[i])] = drawn[static_cast<Eigen::Index>(i)];
    for (const Chain& chain : tile.chains) {
        lengths.push_back(0);
        for (int i = 0; i < chain.edge_count(); ++i) lengths.back() += leaving[at(chain.vertices[at(i)])];
    }
    return lengths;
}

void waive(FlatTile& tile, const std::vector<Mating>& mates, double tolerance) {
    std::vector<Finding>& findings = tile.verdict.findings;
    const auto is_chain = [](const Finding& finding) { return finding.chain >= 0; };
    if (std::none_of(findings.begin(), findings.end(), is_chain)) return;
    const std::vector<double> lengths = chain_lengths(tile.tile);
    const auto move_to_waived = [&](auto passes) {
        const auto from = std::stable_partition(findings.begin(), findings.end(), std::not_fn(passes));
        tile.verdict.waived.insert(tile.verdict.waived.end(), from, findings.end());
        findings.erase(from, findings.end());
    };
    move_to_waived([&](const Finding& finding) {
        if (finding.chain < 0) return false;
        const auto c = static_cast<std::size_t>(finding.chain);
        return mates[c].agrees && mates[c].sewn >= (1 - tolerance) * lengths[c];
    });
    if (std::none_of(findings.begin(), findings.end(), is_chain))
        move_to_waived([](const Finding& finding) { return finding.code == "perimeter"; });
}

}  // namespace

void judge_seams(CutPlan& plan) {
    const auto name = [&](const SeamSide& side) { return plan.tiles[at(side.tile)].tile.name; };
    for (std::size_t i = 0; i < plan.seams.size(); ++i) {
        const SeamWalk& walk = plan.walks[i];
        if (!walk.ok)
            plan.findings.push_back({"seam", message(plan.seams[i], walk, plan), walk.worst,
                                     walk.drift_max / millimetre, walk.limit / millimetre});
        else if (!walk.is_certain())
            plan.findings.push_back(
                {"uncertain", uncertain_text(plan.seams[i], name(plan.seams[i].a), name(plan.seams[i].b), walk.limit),
                 walk.worst, walk.uncertainty / millimetre, walk.limit / millimetre});
    }
    const std::vector<std::vector<Mating>> mates = mate(plan);
    for (std::size_t t = 0; t < plan.tiles.size(); ++t) waive(plan.tiles[t], mates[t], plan.tolerances.length);
}

std::string uncertain_text(const Seam& seam, const std::string& tile_a, const std::string& tile_b, double limit) {
    // A chord is shorter than an arc that turns by t by t^2 / 24 of its length.
    const double turn = std::sqrt(24 * limit / seam.length);
    return "seam " + seam.id + ": the meshes of " + tile_a + " and " + tile_b + " leave " + in_mm(seam.uncertainty, 2) +
           " of its length uncertain, the limit is " + in_mm(limit, 2) +
           ": they do not show whether a polygon or a curve through its corners is intended; export a mesh whose edges "
           "turn by less than " +
           format_fixed(std::floor(turn / degree), 0) + " degrees from one to the next along it, or by more than " +
           format_fixed(corner_turn / degree, 0) + " at intended corners";
}

}  // namespace ripstop
