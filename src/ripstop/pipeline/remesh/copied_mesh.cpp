#include "ripstop/pipeline/remesh/copied_mesh.h"

#include <algorithm>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

constexpr double equal_vertex = 1.5e-4;  // [m], one and a half times the tolerance of equal tiles

Vec3 moved(const Vec3& x, const Likeness& likeness) {
    return likeness.motion * (likeness.mirrored ? Vec3(-x.x(), x.y(), x.z()) : x);
}

/// For each node of `first`, the node of `boundary` at its place; empty if one is missing.
std::vector<int> matching_nodes(const NewBoundary& first, const NewBoundary& boundary, const Likeness& likeness) {
    const int count = static_cast<int>(boundary.nodes.size());
    if (static_cast<int>(first.nodes.size()) != count) return {};
    const auto near = [&](int k, int i) {
        return (moved(first.nodes[at(k)].position, likeness) - boundary.nodes[at(i)].position).norm() < equal_vertex;
    };
    const int step = likeness.mirrored ? count - 1 : 1;
    for (int start = 0; start < count; ++start) {
        if (!near(0, start)) continue;
        std::vector<int> match;
        for (int k = 0, i = start; k < count && near(k, i); ++k, i = (i + step) % count) match.push_back(i);
        if (static_cast<int>(match.size()) == count) return match;
    }
    return {};
}

bool corners_match(const NewBoundary& first, const NewBoundary& boundary, const std::vector<int>& number) {
    std::vector<int> there, here = boundary.chain_starts;
    for (const int start : first.chain_starts) there.push_back(number[at(start)]);
    std::sort(there.begin(), there.end());
    std::sort(here.begin(), here.end());
    return there == here;
}

}  // namespace

std::optional<Tile> copied_mesh(const Tile& tile, const NewBoundary& boundary, const Tile& made,
                                const NewBoundary& first, const Likeness& likeness) {
    if (tile.grain.field.rows() > 0) return {};
    std::vector<int> number = matching_nodes(first, boundary, likeness);
    if (number.empty() || !corners_match(first, boundary, number)) return {};
    TriangleMesh mesh = made.mesh;
    for (int v = static_cast<int>(number.size()); v < mesh.vertex_count(); ++v) {
        mesh.positions.row(v) = moved(made.mesh.positions.row(v), likeness);
        number.push_back(v);
    }
    for (std::size_t i = 0; i < boundary.nodes.size(); ++i)
        mesh.positions.row(static_cast<Eigen::Index>(i)) = boundary.nodes[i].position;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            mesh.triangles(t, likeness.mirrored ? 2 - k : k) = number[at(made.mesh.triangles(t, k))];
    return tile_on_mesh(tile, boundary, std::move(mesh), {});
}

}  // namespace ripstop
