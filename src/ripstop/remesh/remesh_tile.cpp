#include "ripstop/remesh/remesh_tile.h"

#include <Eigen/Geometry>
#include <stdexcept>

#include "ripstop/base/error.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/remesh/mesh_state.h"

namespace ripstop {
namespace {

constexpr double least_agreement = 0.5;  // cosine between a new triangle and the old one beneath it

Vec3 normal_of(const TriangleMesh& mesh, int t) {
    return (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)).normalized();
}

/// Near a crease a triangle may lie across it, or beside a nearer one of the other side.
void require_upright(const TriangleMesh& old, const DiskRemesh& made, const std::vector<bool>& at_crease) {
    for (int t = 0; t < made.mesh.triangle_count(); ++t) {
        const int origin = made.origin[static_cast<std::size_t>(t)];
        const double limit = at_crease[static_cast<std::size_t>(origin)] ? 0 : least_agreement;
        if (!(normal_of(made.mesh, t).dot(normal_of(old, origin)) > limit))
            throw std::runtime_error("the new triangles would fold over");
    }
}

std::vector<bool> triangles_at(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& creases) {
    std::vector<bool> vertex(static_cast<std::size_t>(mesh.vertex_count()), false), triangle;
    for (const auto& [a, b] : creases) vertex[static_cast<std::size_t>(a)] = vertex[static_cast<std::size_t>(b)] = true;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        bool any = false;
        for (int k = 0; k < 3; ++k) any = any || vertex[static_cast<std::size_t>(mesh.triangles(t, k))];
        triangle.push_back(any);
    }
    return triangle;
}

/// The chains over vertices 0, 1, … of the boundary.
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

Tile tile_on_mesh(const Tile& tile, const NewBoundary& boundary, TriangleMesh mesh, const std::vector<int>& origin) {
    Tile result = tile;
    result.drawn.reset();
    try {
        result.boundary = require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), tile.name);
    } catch (const InputError&) {
        throw std::runtime_error("the new mesh is no disk");
    }
    result.chains = chains_of(boundary);
    if (tile.grain.field.rows() > 0) {
        result.grain.field.resize(mesh.triangle_count(), 3);
        for (int t = 0; t < mesh.triangle_count(); ++t)
            result.grain.field.row(t) = tile.grain.field.row(origin[static_cast<std::size_t>(t)]);
    }
    result.curve_lengths.resize(static_cast<Eigen::Index>(boundary.nodes.size()));
    for (std::size_t i = 0; i < boundary.nodes.size(); ++i)
        result.curve_lengths[static_cast<Eigen::Index>(i)] = boundary.nodes[i].length;
    result.mesh = std::move(mesh);
    return result;
}

namespace {

Tile remesh_once(const Tile& tile, const NewBoundary& boundary, const SmoothSurface& surface,
                 const std::vector<std::array<int, 2>>& creases, double edge_length) {
    std::vector<BoundaryPlace> places;
    for (const BoundaryNode& node : boundary.nodes) places.push_back(node.place);
    DiskRemesh made = remesh_disk(tile.mesh, tile.boundary, places, creases, edge_length);
    for (Eigen::Index v = 0; v < made.mesh.positions.rows(); ++v) {
        const std::size_t i = static_cast<std::size_t>(v);
        made.mesh.positions.row(v) =
            i < boundary.nodes.size() ? boundary.nodes[i].position : surface.at(made.places[i]);
    }
    require_upright(tile.mesh, made, triangles_at(tile.mesh, creases));
    return tile_on_mesh(tile, boundary, std::move(made.mesh), made.origin);
}

}  // namespace

Tile remesh_tile(const Tile& tile, const NewBoundary& boundary, double edge_length) {
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const std::vector<std::array<int, 2>> creases = find_creases(tile.mesh, adjacency);
    const SmoothSurface surface(tile.mesh, adjacency, tile.boundary, creases, boundary.slopes);
    for (const double share : {1.0, 0.7}) {
        try {
            return remesh_once(tile, boundary, surface, creases, share * edge_length);
        } catch (const std::exception&) {  // where the tile is narrow or folded, smaller triangles may fit
        }
    }
    return remesh_once(tile, boundary, surface, creases, edge_length / 2);
}

}  // namespace ripstop
