#include "ripstop/pipeline/redesign/weld_tiles.h"

#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/text/units.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double same_vertex = 1e-5;  // [m]
constexpr double warps_apart = 15 * degree;

/// The vertices of a side in order, with its ends; empty if it begins or ends within an edge.
std::vector<int> vertices_of(const Tile& tile, const SeamSide& side) {
    const Eigen::VectorXd drawn = drawn_lengths(tile);
    std::vector<int> vertices;
    for (const SeamPart& part : side.parts) {
        if (std::abs(part.length / drawn[part.edge] - 1) > 1e-6) return {};
        vertices.push_back(tile.boundary[at(part.edge)]);
    }
    if (vertices.empty()) return {};
    const auto last = static_cast<std::size_t>(side.parts.back().edge) + 1;
    vertices.push_back(tile.boundary[last % tile.boundary.size()]);
    return vertices;
}

/// For each vertex of `b` on the seam, the vertex of `a` at its place, -1 elsewhere; empty if they do not coincide.
std::vector<int> partners(const Tile& a, const Tile& b, const Seam& seam) {
    const std::vector<int> along = vertices_of(a, seam.a), against = vertices_of(b, seam.b);
    if (along.empty() || along.size() != against.size()) return {};
    std::vector<int> partner(static_cast<std::size_t>(b.mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < along.size(); ++i) {
        const int u = along[i], v = against[against.size() - 1 - i];
        if ((a.mesh.positions.row(u) - b.mesh.positions.row(v)).norm() > same_vertex) return {};
        partner[at(v)] = u;
    }
    return partner;
}

/// Gives the edges of the welded tile their lengths on the curves of the original tiles.
void keep_curve_lengths(const Tile& from, const std::vector<int>& number, Tile& welded) {
    std::vector<int> place(static_cast<std::size_t>(welded.mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < welded.boundary.size(); ++i)
        place[static_cast<std::size_t>(welded.boundary[i])] = static_cast<int>(i);
    const Eigen::VectorXd drawn = drawn_lengths(from);
    const std::size_t n = from.boundary.size(), m = welded.boundary.size();
    for (std::size_t i = 0; i < n; ++i) {
        const int u = number[static_cast<std::size_t>(from.boundary[i])];
        const int v = number[static_cast<std::size_t>(from.boundary[(i + 1) % n])];
        const int at = place[static_cast<std::size_t>(u)];
        if (at >= 0 && welded.boundary[(static_cast<std::size_t>(at) + 1) % m] == v)
            welded.curve_lengths[at] = drawn[static_cast<Eigen::Index>(i)];
    }
}

}  // namespace

std::optional<Tile> weld_tiles(const Tile& a, const Tile& b, const Seam& seam) {
    if (seam.a.tile == seam.b.tile || a.fabric != b.fabric || a.compensation.any() || b.compensation.any())
        return std::nullopt;
    const double sign = a.grain.direction.dot(b.grain.direction) < 0 ? -1 : 1;
    if (sign * a.grain.direction.dot(b.grain.direction) < std::cos(warps_apart)) return std::nullopt;
    const std::vector<int> partner = partners(a, b, seam);
    if (partner.empty()) return std::nullopt;
    std::vector<int> number_a(static_cast<std::size_t>(a.mesh.vertex_count())), number_b = partner;
    for (std::size_t v = 0; v < number_a.size(); ++v) number_a[v] = static_cast<int>(v);
    int count = a.mesh.vertex_count();
    for (int& v : number_b)
        if (v < 0) v = count++;
    TriangleMesh mesh;
    mesh.positions.resize(count, 3);
    for (int v = 0; v < b.mesh.vertex_count(); ++v) mesh.positions.row(number_b[at(v)]) = b.mesh.positions.row(v);
    mesh.positions.topRows(a.mesh.vertex_count()) = a.mesh.positions;
    mesh.triangles.resize(a.mesh.triangle_count() + b.mesh.triangle_count(), 3);
    mesh.triangles.topRows(a.mesh.triangle_count()) = a.mesh.triangles;
    for (int t = 0; t < b.mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            mesh.triangles(a.mesh.triangle_count() + t, k) = number_b[at(b.mesh.triangles(t, k))];
    TileOptions options;
    options.warp = a.grain.direction + sign * b.grain.direction;
    options.warp_source = "mean of both tiles";
    Tile welded = make_tile(a.name + " + " + b.name, std::move(mesh), options);
    welded.curve_lengths = edge_lengths(welded.mesh.positions, closed(welded.boundary));
    welded.fabric = a.fabric;
    keep_curve_lengths(a, number_a, welded);
    keep_curve_lengths(b, number_b, welded);
    return welded;
}

}  // namespace ripstop
