#include "ripstop/pipeline/redesign/propose_redesign.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/measure/equal_tiles.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/judge_zigzags.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/mesh/change/split.h"
#include "ripstop/model/plan/better_verdict.h"
#include "ripstop/pipeline/redesign/half_tile.h"
#include "ripstop/pipeline/redesign/weld_tiles.h"
#include "ripstop/tile/find_zigzags.h"

namespace ripstop {
namespace {

struct StraightCut {
    bool along = true;  ///< along the warp, which is +x of the cloth; else across it
    double at = 0;      ///< the coordinate that is constant along the cut
};

/// The flat position of the vertex nearest to a point of the surface.
Vec2 on_cloth(const FlatTile& tile, const Vec3& point) {
    Eigen::Index nearest = 0;
    (tile.tile.mesh.positions.rowwise() - point.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    return tile.flattening.positions.row(nearest);
}

/// Cuts to try: at least a twentieth of the piece apart and an eighth away from its ends.
std::vector<StraightCut> lines_to_try(const FlatTile& tile) {
    const Points2& flat = tile.flattening.positions;
    const std::array<Vec3, 4> places{tile.bounds.centre, tile.accuracy.worst_warp, tile.accuracy.worst_weft,
                                     tile.accuracy.worst_shear};
    std::vector<StraightCut> lines;
    for (const bool along : {true, false}) {
        const Eigen::Index axis = along ? 1 : 0;
        const double low = flat.col(axis).minCoeff(), size = flat.col(axis).maxCoeff() - low;
        std::vector<double> wanted{low + size / 2, 0};  // the middle, and the middle of the area
        for (const Vec3& place : places) wanted.push_back(on_cloth(tile, place)[axis]);
        wanted.insert(wanted.end(), {low + size / 3, low + 2 * size / 3});
        std::vector<double> kept;
        for (const double at : wanted) {
            const bool inside = at > low + size / 8 && at < low + 7 * size / 8;
            const auto is_near = [&](double other) { return std::abs(other - at) < size / 20; };
            if (inside && std::none_of(kept.begin(), kept.end(), is_near)) kept.push_back(at);
        }
        for (const double at : kept) lines.push_back({along, at});
    }
    return lines;
}

Trial try_tile(const Tile& tile, const Method& method, const Fabric& fabric, const Tolerances& tolerances,
               Flattening* flattening = nullptr) {
    Trial trial;
    trial.triangles = tile.mesh.triangle_count();
    const Flattening flat = method.flatten(tile, fabric);
    if (flat.positions.rows() != tile.mesh.vertex_count())
        throw InputError("tile " + tile.name + ": " + flat.summary.text());
    trial.accuracy = measure_accuracy(tile, flat.positions, fabric, flat.edges_on_curve);
    trial.verdict = judge(tile, measure_bounds(tile), flat, trial.accuracy, tolerances);
    judge_zigzags(tile, walk_zigzags(tile, flat.positions, find_zigzags({&tile}, {})), tolerances, trial.verdict);
    if (flattening) *flattening = flat;
    return trial;
}

std::optional<SplitProposal> try_line(const FlatTile& tile, const StraightCut& line, const Method& method,
                                      const Fabric& fabric, const Tolerances& tolerances) {
    const Points2& flat = tile.flattening.positions;
    const Eigen::VectorXd field =
        line.along ? Eigen::VectorXd(flat.col(1).array() - line.at) : Eigen::VectorXd(line.at - flat.col(0).array());
    const std::optional<MeshSplit> split = split_mesh(tile.tile.mesh, field);
    if (!split) return std::nullopt;
    SplitProposal proposal;
    proposal.direction = line.along ? "along the warp" : "across the warp";
    for (const int v : split->left.cut) proposal.line.emplace_back(split->left.mesh.positions.row(v));
    try {
        proposal.halves = {
            try_tile(make_half_tile(tile.tile, split->left, tile.tile.name + " left"), method, fabric, tolerances),
            try_tile(make_half_tile(tile.tile, split->right, tile.tile.name + " right"), method, fabric, tolerances)};
    } catch (const InputError&) {
        return std::nullopt;  // the half cannot be made a tile, so there is no proposal
    }
    return proposal;
}

int better_halves(const SplitProposal& proposal, const Verdict& whole) {
    return static_cast<int>(std::count_if(proposal.halves.begin(), proposal.halves.end(),
                                          [&](const Trial& half) { return is_better(half.verdict, whole); }));
}

/// Whether both halves are better than the whole, or at least one can be made.
bool helps(const SplitProposal& proposal, const Verdict& whole) {
    const auto is_good = [](const Trial& half) { return half.verdict.manufacturable(); };
    return better_halves(proposal, whole) == 2 || std::any_of(proposal.halves.begin(), proposal.halves.end(), is_good);
}

/// The score of a proposal; less is better.
std::tuple<int, std::size_t, std::size_t, double> rank(const SplitProposal& proposal, const Verdict& whole) {
    const std::size_t left = proposal.halves[0].verdict.findings.size();
    const std::size_t right = proposal.halves[1].verdict.findings.size();
    return {-better_halves(proposal, whole), std::max(left, right), left + right,
            proposal.halves[0].accuracy.energy + proposal.halves[1].accuracy.energy};
}

bool is_sound(const FlatTile& tile) {
    return tile.flattening.summary.usable() && tile.accuracy.flipped == 0 && tile.is_flat();
}

/// The place of the proposal on a tile that is a moved, perhaps mirrored, copy of the first.
SplitProposal moved(SplitProposal proposal, const Likeness& likeness) {
    const auto move = [&](Vec3& point) {
        if (likeness.mirrored) point.x() *= -1;
        point = likeness.motion * point;
    };
    for (Vec3& point : proposal.line) move(point);
    for (Trial& half : proposal.halves) {
        for (Finding& finding : half.verdict.findings) move(finding.at);
        Accuracy& a = half.accuracy;
        for (Vec3* place :
             {&a.worst_edge, &a.worst_warp, &a.worst_weft, &a.worst_shear, &a.worst_flip, &a.worst_overlap})
            move(*place);
    }
    if (likeness.mirrored) std::swap(proposal.halves[0], proposal.halves[1]);
    return proposal;
}

/// The proposal for a tile that is cut like `first`; empty if the tiles are no more alike than their pieces.
std::optional<SplitProposal> taken_over(const FlatTile& first, const FlatTile& tile) {
    constexpr double tolerance = 3e-4;  // [m]: each differs from the first of its kind by at most a third of it
    if (!first.proposal) return std::nullopt;
    const Likeness likeness = find_equal_tiles({first.tile, tile.tile}, tolerance)[1];
    if (likeness.to < 0) return std::nullopt;
    SplitProposal proposal = moved(*first.proposal, likeness);
    proposal.findings_before = static_cast<int>(tile.verdict.findings.size());
    return proposal;
}

}  // namespace

std::optional<SplitProposal> propose_split(const FlatTile& tile, const Method& method, const Fabric& fabric,
                                           const Tolerances& tolerances) {
    if (!is_sound(tile)) return std::nullopt;
    std::optional<SplitProposal> best;
    int tried = 0;
    for (const StraightCut& line : lines_to_try(tile)) {
        std::optional<SplitProposal> here = try_line(tile, line, method, fabric, tolerances);
        if (!here) continue;
        ++tried;
        if (!helps(*here, tile.verdict)) continue;
        if (!best || rank(*here, tile.verdict) < rank(*best, tile.verdict)) best = std::move(here);
    }
    if (!best) return std::nullopt;
    best->tried = tried;
    best->findings_before = static_cast<int>(tile.verdict.findings.size());
    return best;
}

bool add_proposals(CutPlan& plan, const Method& method, int threads, const ProposeLimits& limits,
                   const Progress& progress) {
    std::vector<std::size_t> failing;
    std::vector<std::vector<std::size_t>> alike;  // for each of them, the other failing tiles that are cut the same
    std::map<int, std::size_t> kinds;
    long triangles = 0;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const FlatTile& tile = plan.tiles[i];
        if (tile.verdict.manufacturable()) continue;
        const auto [kind, is_new] =
            kinds.emplace(tile.equal_to >= 0 ? tile.equal_to : static_cast<int>(i), failing.size());
        if (!is_new) {
            alike[kind->second].push_back(i);
            continue;
        }
        failing.push_back(i);
        alike.emplace_back();
        triangles += tile.tile.mesh.triangle_count();
    }
    if (static_cast<long>(failing.size()) > limits.kinds || triangles > limits.triangles) return false;
    StepCounter counter(static_cast<int>(failing.size()), progress);
    parallel_for(static_cast<int>(failing.size()), threads, [&](int k) {
        FlatTile& tile = plan.tiles[failing[at(k)]];
        tile.proposal = propose_split(tile, method, plan.fabric_of(tile.tile), plan.tolerances_of(tile.tile));
        for (const std::size_t other : alike[at(k)]) plan.tiles[other].proposal = taken_over(tile, plan.tiles[other]);
        counter.done("seams to draw in " + tile.tile.name);
    });
    return true;
}

std::vector<MergeProposal> propose_merges(const CutPlan& plan, const Method& method, int threads,
                                          const Progress& progress) {
    std::vector<std::optional<MergeProposal>> found(plan.seams.size());
    std::vector<char> holds_further(plan.seams.size(), false);
    for (std::size_t s = 0; s < plan.seams.size(); ++s)
        if (const auto& into = plan.seams[s].into) holds_further[s] = holds_further[at(into->seam)] = true;
    StepCounter counter(static_cast<int>(plan.seams.size()), progress);
    const auto try_seam = [&](int i) {
        const Seam& seam = plan.seams[at(i)];
        if (holds_further[at(i)]) return;  // an additional sheet would lose its seam
        const FlatTile& a = plan.tiles[at(seam.a.tile)];
        const FlatTile& b = plan.tiles[at(seam.b.tile)];
        try {
            const std::optional<Tile> welded = weld_tiles(a.tile, b.tile, seam);
            if (!welded) return;
            Flattening flat;
            const Fabric& fabric = plan.fabric_of(*welded);
            const Trial trial = try_tile(*welded, method, fabric, plan.tolerances_of(*welded), &flat);
            const double width = flat.positions.col(1).maxCoeff() - flat.positions.col(1).minCoeff();
            if (trial.verdict.manufacturable() && width <= fabric.roll_width)
                found[at(i)] = {seam.a.tile, seam.b.tile, i, trial};
        } catch (const InputError&) {
            return;  // together they do not form a tile
        }
    };
    parallel_for(static_cast<int>(plan.seams.size()), threads, [&](int i) {
        try_seam(i);
        counter.done("tiles as one over " + plan.seams[at(i)].id);
    });
    std::vector<MergeProposal> merges;
    for (std::optional<MergeProposal>& merge : found)
        if (merge) merges.push_back(std::move(*merge));
    return merges;
}

}  // namespace ripstop
