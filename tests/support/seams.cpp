#include "support/seams.h"

#include <array>
#include <map>

#include "ripstop/measure/judge_seams.h"
#include "ripstop/measure/seam_walk.h"
#include "support/shapes.h"

namespace ripstop::testing {
namespace {

using Key = std::array<double, 6>;

/// A boundary edge and the chain it lies in.
struct Edge {
    int tile = 0, index = 0, chain = 0, next = 0;  ///< next: the edge after it in the same chain, -1 at its end
};

Key key(const Vec3& a, const Vec3& b) {
    return {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
}

int place_of(const Tile& tile, int vertex) {
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        if (tile.boundary[i] == vertex) return static_cast<int>(i);
    return -1;
}

std::vector<Edge> edges_of(const Tile& tile, int t) {
    std::vector<Edge> edges;
    for (std::size_t c = 0; c < tile.chains.size(); ++c) {
        const Chain& chain = tile.chains[c];
        for (int i = 0; i < chain.edge_count(); ++i) {
            const int at = place_of(tile, chain.vertices[static_cast<std::size_t>(i)]);
            const int next =
                i + 1 < chain.edge_count() ? place_of(tile, chain.vertices[static_cast<std::size_t>(i) + 1]) : -1;
            edges.push_back({t, at, static_cast<int>(c), next});
        }
    }
    return edges;
}

Vec3 end_of(const Tile& tile, int edge, int end) {
    const auto i = static_cast<std::size_t>(edge + end) % tile.boundary.size();
    return tile.mesh.positions.row(tile.boundary[i]);
}

}  // namespace

double length(const SeamSide& side) {
    double sum = 0;
    for (const SeamPart& part : side.parts) sum += part.length;
    return sum;
}

Envelope sewn(std::vector<Tile> tiles) {
    Envelope envelope{std::move(tiles)};
    std::map<Key, Edge> by_ends;
    std::vector<Edge> all;
    for (std::size_t t = 0; t < envelope.tiles.size(); ++t)
        for (const Edge& edge : edges_of(envelope.tiles[t], static_cast<int>(t))) {
            all.push_back(edge);
            by_ends[key(end_of(envelope.tiles[t], edge.index, 0), end_of(envelope.tiles[t], edge.index, 1))] = edge;
        }
    const Edge* last = nullptr;
    Edge last_mate;
    for (const Edge& edge : all) {
        const Tile& tile = envelope.tiles[static_cast<std::size_t>(edge.tile)];
        const auto found = by_ends.find(key(end_of(tile, edge.index, 1), end_of(tile, edge.index, 0)));
        if (found == by_ends.end() || found->second.tile <= edge.tile) continue;
        const Edge& mate = found->second;
        const double drawn = drawn_lengths(tile)[edge.index];
        const bool goes_on = last && last->tile == edge.tile && last->next == edge.index &&
                             last_mate.tile == mate.tile && mate.next == last_mate.index;
        if (!goes_on) {
            Seam seam;
            seam.id = std::string("S").append(std::to_string(envelope.seams.size() + 1));
            seam.a = {edge.tile, edge.chain, {}};
            seam.b = {mate.tile, mate.chain, {}};
            envelope.seams.push_back(seam);
        }
        Seam& seam = envelope.seams.back();
        seam.a.parts.push_back({edge.index, drawn});
        seam.b.parts.insert(seam.b.parts.begin(), {mate.index, drawn});
        seam.length += drawn;
        last = &edge;
        last_mate = mate;
    }
    return envelope;
}

SeamSide run_of_chain(const Envelope& envelope, int tile, int chain, int from, int to) {
    const Tile& of = envelope.tiles[static_cast<std::size_t>(tile)];
    const Eigen::VectorXd drawn = drawn_lengths(of);
    SeamSide side{tile, chain, {}};
    int i = 0;
    for (const Edge& edge : edges_of(of, tile)) {
        if (edge.chain != chain) continue;
        if (i >= from && i < to) side.parts.push_back({edge.index, drawn[edge.index]});
        ++i;
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

}  // namespace ripstop::testing
