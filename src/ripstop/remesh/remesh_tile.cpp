#include "ripstop/remesh/remesh_tile.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/remesh/explained_area.h"
#include "ripstop/remesh/facet_row.h"
#include "ripstop/remesh/mesh_state.h"
#include "ripstop/remesh/row_mesh.h"

namespace ripstop {
namespace {

constexpr double least_agreement = 0.5;         // cosine between a new triangle and the old one below it
constexpr double most_beyond = 0.05 * percent;  // of area, in addition to what the mesh explains
constexpr double most_triangles = 6000;         // limit for a second attempt
constexpr double next_share = 0.7;

Vec3 normal_of(const TriangleMesh& mesh, int t) {
    return (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).normalized();
}

/// Throws if a new triangle deviates too much from the old one. At a crease the limit is wider: a triangle may lie
/// across it, or be nearest to one of its other side.
void require_upright(const TriangleMesh& old, const DiskRemesh& made, const std::vector<bool>& at_crease) {
    for (int t = 0; t < made.mesh.triangle_count(); ++t) {
        const int origin = made.origin[at(t)];
        const double limit = at_crease[at(origin)] ? 0 : least_agreement;
        if (!(normal_of(made.mesh, t).dot(normal_of(old, origin)) > limit))
            throw std::runtime_error("the new triangles would fold over");
    }
}

std::vector<bool> triangles_at(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& creases) {
    std::vector<bool> vertex(static_cast<std::size_t>(mesh.vertex_count()), false), triangle;
    for (const auto& [a, b] : creases) vertex[at(a)] = vertex[at(b)] = true;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        bool any = false;
        for (int k = 0; k < 3; ++k) any = any || vertex[at(mesh.triangles(t, k))];
        triangle.push_back(any);
    }
    return triangle;
}

/// The chains over the vertices 0, 1, … of the boundary.
std::vector<Chain> chains_of(const NewBoundary& boundary) {
    const int count = static_cast<int>(boundary.nodes.size());
    std::vector<Chain> chains;
    for (std::size_t c = 0; c < boundary.chain_starts.size(); ++c) {
        const int end =
            c + 1 < boundary.chain_starts.size() ? boundary.chain_starts[c + 1] : boundary.chain_starts.front() + count;
        chains.emplace_back();
        for (int v = boundary.chain_starts[c]; v <= end; ++v) chains.back().vertices.push_back(v % count);
    }
    return chains;
}

}  // namespace

Tile outline_tile(const Tile& tile, const NewBoundary& boundary) {
    Tile outline;
    outline.name = tile.name;
    outline.mesh.positions.resize(static_cast<Eigen::Index>(boundary.nodes.size()), 3);
    outline.mesh.triangles.resize(0, 3);
    for (std::size_t i = 0; i < boundary.nodes.size(); ++i) {
        outline.mesh.positions.row(static_cast<Eigen::Index>(i)) = boundary.nodes[i].position;
        outline.boundary.push_back(static_cast<int>(i));
    }
    outline.chains = chains_of(boundary);
    return outline;
}

Tile tile_on_mesh(const Tile& tile, const NewBoundary& boundary, TriangleMesh mesh, const std::vector<int>& origin) {
    Tile result = tile;
    result.drawn.reset();
    try {
        result.boundary = require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), tile.name);
    } catch (const InputError&) {
        throw std::runtime_error("the new mesh is not a disk");
    }
    result.chains = chains_of(boundary);
    if (tile.grain.field.rows() > 0) {
        result.grain.field.resize(mesh.triangle_count(), 3);
        for (int t = 0; t < mesh.triangle_count(); ++t) result.grain.field.row(t) = tile.grain.field.row(origin[at(t)]);
    }
    result.curve_lengths.resize(static_cast<Eigen::Index>(boundary.nodes.size()));
    for (std::size_t i = 0; i < boundary.nodes.size(); ++i)
        result.curve_lengths[static_cast<Eigen::Index>(i)] = boundary.nodes[i].length;
    result.mesh = std::move(mesh);
    return result;
}

namespace {

using Surface = std::function<Vec3(const MeshPlace&)>;

void require_explained(const Tile& tile, const TriangleMesh& made, const ExplainedArea& explained) {
    const double gain = surface_area(made) / surface_area(tile.mesh) - 1;
    if (explained.beyond(gain) > most_beyond)
        throw std::runtime_error("its area would change by " + format_fixed(std::abs(gain) / percent, 2) +
                                 " %, more than the turns of its mesh explain");
}

/// The tile on the mesh of a facet row; empty if that fails.
std::optional<RemeshedTile> remesh_row(const Tile& tile, const NewBoundary& boundary, const FacetRow& row) {
    std::optional<RowMesh> made = mesh_row(tile, row, boundary);
    if (!made) return {};
    return RemeshedTile{tile_on_mesh(tile, boundary, std::move(made->mesh), made->origin), made->distance_max};
}

/// The largest distance of the new vertices from the old triangles.
double distance_between(const Tile& tile, const NewBoundary& boundary, const DiskRemesh& made) {
    double most = 0;
    for (std::size_t v = 0; v < made.places.size(); ++v) {
        Vec3 there = Vec3::Zero();
        if (v < boundary.nodes.size()) {
            const BoundaryPlace& place = boundary.nodes[v].place;
            const std::size_t edge = static_cast<std::size_t>(place.edge);
            const Vec3 start = tile.mesh.positions.row(tile.boundary[edge]);
            const Vec3 end = tile.mesh.positions.row(tile.boundary[(edge + 1) % tile.boundary.size()]);
            there = start + place.share * (end - start);
        } else {
            const MeshPlace& place = made.places[v];
            for (int k = 0; k < 3; ++k) there += place.weights[k] * tile.mesh.corner(place.triangle, k);
        }
        most = std::max(most, (Vec3(made.mesh.positions.row(static_cast<Eigen::Index>(v))) - there).norm());
    }
    return most;
}

RemeshedTile remesh_once(const Tile& tile, const NewBoundary& boundary, const Surface& surface,
                         const std::vector<std::array<int, 2>>& creases, const ExplainedArea& explained,
                         double edge_length) {
    std::vector<BoundaryPlace> places;
    for (const BoundaryNode& node : boundary.nodes) places.push_back(node.place);
    DiskRemesh made = remesh_disk(tile.mesh, tile.boundary, places, creases, edge_length);
    for (Eigen::Index v = 0; v < made.mesh.positions.rows(); ++v) {
        const std::size_t i = static_cast<std::size_t>(v);
        made.mesh.positions.row(v) = i < boundary.nodes.size() ? boundary.nodes[i].position : surface(made.places[i]);
    }
    require_upright(tile.mesh, made, triangles_at(tile.mesh, creases));
    require_explained(tile, made.mesh, explained);
    const double distance = distance_between(tile, boundary, made);
    return {tile_on_mesh(tile, boundary, std::move(made.mesh), made.origin), distance};
}

}  // namespace

RemeshedTile remesh_tile(const Tile& tile, const NewBoundary& boundary, double edge_length) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const std::vector<std::array<int, 2>> creases = find_creases(tile.mesh, adjacency);
    const std::optional<FacetRow> row = FacetRow::find(tile, adjacency, boundary.slopes);
    const ExplainedArea explained = explained_area(tile, adjacency, boundary);
    if (row) {
        if (std::optional<RemeshedTile> made = remesh_row(tile, boundary, *row)) {
            require_explained(tile, made->tile.mesh, explained);
            return *made;
        }
    }
    std::optional<SmoothSurface> smooth;
    if (!row) smooth.emplace(tile.mesh, adjacency, tile.boundary, creases, boundary.slopes);
    const Surface surface = [&](const MeshPlace& place) { return row ? row->at(place) : smooth->at(place); };
    const double area = surface_area(tile.mesh);
    for (const double share : {1.0, next_share}) {
        try {
            return remesh_once(tile, boundary, surface, creases, explained, share * edge_length);
        } catch (const std::exception&) {  // in a narrow or folded tile smaller triangles may fit
            if (next_share * share * edge_length < edge_of(area, most_triangles)) throw;
        }
    }
    return remesh_once(tile, boundary, surface, creases, explained, edge_length / 2);
}

}  // namespace ripstop
