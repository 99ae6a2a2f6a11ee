#include "support/seams.h"

#include "ripstop/measure/judge_seams.h"
#include "ripstop/measure/walk_seams.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/sewn.h"
#include "support/shapes.h"

namespace ripstop::testing {

double length(const SeamSide& side) {
    double sum = 0;
    for (const SeamPart& part : side.parts) sum += part.length;
    return sum;
}

SeamSide run_of_chain(const Envelope& envelope, int tile, int chain, int from, int to) {
    const Tile& of = envelope.tiles[static_cast<std::size_t>(tile)];
    const Eigen::VectorXd drawn = drawn_lengths(of);
    const std::vector<int> edges = edges_of_chain(of, chain);
    SeamSide side{tile, chain, {}};
    for (int i = from; i < to; ++i) {
        const int edge = edges[static_cast<std::size_t>(i)];
        side.parts.push_back({edge, drawn[edge]});
    }
    return side;
}

FlatTile flattened(const Tile& tile, const Points2& positions, bool on_curve) {
    FlatTile flat;
    flat.tile = tile;
    flat.method = "by hand";
    flat.flattening.positions = positions;
    flat.flattening.summary.termination = Termination::converged;
    flat.flattening.edges_on_curve = on_curve;
    return flat;
}

std::vector<FlatTile> laid_flat(const Envelope& envelope) {
    std::vector<FlatTile> flat;
    for (const Tile& tile : envelope.tiles) flat.push_back(flattened(tile, tile.mesh.positions.leftCols(2)));
    return flat;
}

CutPlan sewn_plan() {
    const auto sheet = [](const std::string& name, double x, double y, double height) {
        TriangleMesh mesh = rectangle(1, height, 4, static_cast<int>(4 * height));
        mesh.positions.col(0).array() += x;
        mesh.positions.col(1).array() += y;
        return make_tile(name, mesh, {.warp = Vec3::UnitX()});
    };
    Envelope envelope = sewn({sheet("left", 0, 0, 2), sheet("low", 1, 0, 1), sheet("high", 1, 1, 1)});
    CutPlan plan;
    plan.tiles = laid_flat(envelope);
    for (FlatTile& tile : plan.tiles) tile.verdict.judged = true;
    plan.tiles[2].flattening.positions.col(1) *= 1.002;
    plan.seams = envelope.seams;
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    return plan;
}

CutPlan unevenly_meshed_plan() {
    const auto sheet = [](const std::string& name, double left) {
        const auto at = [&](double u, double v) { return Vec3(left + u, v == 0.5 ? 0.1 : v, 0); };
        return make_tile(name, grid(1, 2, at), {.warp = Vec3::UnitX()});
    };
    const Envelope envelope = sewn({sheet("left", 0), sheet("right", 1)});
    CutPlan plan;
    plan.tiles = laid_flat(envelope);
    for (FlatTile& tile : plan.tiles) tile.verdict.judged = true;
    plan.tiles[1].flattening.positions.col(1) *= 1.001;
    plan.seams = envelope.seams;
    plan.walks = walk_seams(plan.tiles, plan.seams, plan.tolerances);
    judge_seams(plan);
    return plan;
}

}  // namespace ripstop::testing
