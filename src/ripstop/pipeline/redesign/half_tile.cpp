#include "ripstop/pipeline/redesign/half_tile.h"

#include <algorithm>
#include <optional>
#include <set>

#include "ripstop/base/index.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"

namespace ripstop {
namespace {

/// The boundary edge of the whole that contains a boundary edge of the half; empty for the cut.
class WholeBoundary {
  public:
    explicit WholeBoundary(const Tile& whole) : place_(static_cast<std::size_t>(whole.mesh.vertex_count()), -1) {
        for (std::size_t i = 0; i < whole.boundary.size(); ++i)
            place_[static_cast<std::size_t>(whole.boundary[i])] = static_cast<int>(i);
        count_ = static_cast<int>(whole.boundary.size());
    }

    std::optional<int> edge_of(const MeshHalf& half, int u, int v) const {
        std::set<int> ends;
        for (const int w : {u, v}) {
            const SplitVertex& at = half.source[static_cast<std::size_t>(w)];
            ends.insert(at.a);
            ends.insert(at.b);
        }
        if (ends.size() != 2) return std::nullopt;
        const int i = place_[static_cast<std::size_t>(*ends.begin())];
        const int k = place_[static_cast<std::size_t>(*ends.rbegin())];
        if (i < 0 || k < 0) return std::nullopt;
        if ((i + 1) % count_ == k) return i;
        if ((k + 1) % count_ == i) return k;
        return std::nullopt;
    }

  private:
    std::vector<int> place_;
    int count_ = 0;
};

std::vector<Vec3> corners_of(const Tile& whole, const MeshHalf& half) {
    std::set<int> of_whole;
    if (whole.chains.size() > 1)  // a single chain has no corner where it begins
        for (const Chain& chain : whole.chains) of_whole.insert(chain.vertices.front());
    std::vector<Vec3> corners;
    for (const int v : half.boundary) {
        const SplitVertex& at = half.source[static_cast<std::size_t>(v)];
        const bool was_corner = at.a == at.b && of_whole.count(at.a) > 0;
        if (was_corner || v == half.cut.front() || v == half.cut.back())
            corners.emplace_back(half.mesh.positions.row(v));
    }
    return corners;
}

/// The chain that contains each boundary edge of the whole.
std::vector<int> chains_of_edges(const Tile& whole) {
    std::vector<int> leaving(static_cast<std::size_t>(whole.mesh.vertex_count()), 0), chains;
    for (std::size_t c = 0; c < whole.chains.size(); ++c)
        for (int i = 0; i < whole.chains[c].edge_count(); ++i)
            leaving[at(whole.chains[c].vertices[at(i)])] = static_cast<int>(c);
    for (const int v : whole.boundary) chains.push_back(leaving[at(v)]);
    return chains;
}

}  // namespace

Tile make_half_tile(const Tile& whole, const MeshHalf& half, const std::string& name) {
    TileOptions options;
    options.corners = corners_of(whole, half);
    options.warp = whole.grain.direction;
    options.warp_source = whole.grain.source;
    options.compensation = whole.compensation;
    options.attributes = whole.attributes;
    options.compensation.chains.clear();
    options.compensation.strain.resize(0, 3);  // these refer to the whole's triangles and edges
    options.compensation.edges.resize(0);
    Tile tile = make_tile(name, half.mesh, options);
    tile.fabric = whole.fabric;
    const WholeBoundary boundary(whole);
    if (whole.curve_lengths.size() > 0) {
        const Eigen::VectorXd chords = edge_lengths(whole.mesh.positions, closed(whole.boundary));
        tile.curve_lengths = edge_lengths(tile.mesh.positions, closed(tile.boundary));
        const std::size_t n = tile.boundary.size();
        for (std::size_t i = 0; i < n; ++i)
            if (const auto edge = boundary.edge_of(half, tile.boundary[i], tile.boundary[(i + 1) % n]))
                tile.curve_lengths[static_cast<Eigen::Index>(i)] *= whole.curve_lengths[*edge] / chords[*edge];
    }
    if (whole.compensation.chains.empty()) return tile;
    const std::vector<int> chain_of = chains_of_edges(whole);
    for (const Chain& chain : tile.chains) {
        const auto edge = boundary.edge_of(half, chain.vertices[0], chain.vertices[1]);
        const std::size_t c = edge ? static_cast<std::size_t>(chain_of[at(*edge)]) : 0;
        const bool given = edge && c < whole.compensation.chains.size();
        tile.compensation.chains.push_back(given ? whole.compensation.chains[c] : 0);
    }
    return tile;
}

}  // namespace ripstop
