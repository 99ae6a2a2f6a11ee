#include "ripstop/mesh/unroll.h"

#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

/// Corner k of a triangle laid flat by `lay_flat`.
Vec2 laid_corner(const Mat22& flat, int k) {
    return k == 0 ? Vec2(Vec2::Zero()) : Vec2(flat.col(k - 1));
}

/// The rotation from the direction of `from` to that of `to`.
Mat22 turn_between(const Vec2& from, const Vec2& to) {
    const Vec2 direction = Vec2(from.dot(to), cross(from, to)).normalized();
    Mat22 turn;
    turn << direction.x(), -direction.y(), direction.y(), direction.x();
    return turn;
}

}  // namespace

std::vector<LayingStep> laying_order(const Adjacency& adjacency, int seed) {
    std::vector<LayingStep> order = {{seed, 0}};
    std::vector<bool> found(static_cast<std::size_t>(adjacency.half_edge_count() / 3), false);
    found[at(seed)] = true;
    for (std::size_t next = 0; next < order.size(); ++next)
        for (int k = 0; k < 3; ++k) {
            const int twin = adjacency.twin(3 * order[next].triangle + k);
            if (twin < 0 || found[at(twin / 3)]) continue;
            found[at(twin / 3)] = true;
            order.push_back({twin / 3, (twin % 3 + 2) % 3});
        }
    return order;
}

int middle_triangle(const TriangleMesh& mesh) {
    const Vec3 centre = centroid(mesh);
    const double equal = 1e-9 * bounding_diagonal(mesh);  // rounding must not decide between equal distances
    int best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const double away = ((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3 - centre).norm();
        if (away >= least - equal) continue;
        least = away;
        best = t;
    }
    return best;
}

std::vector<LaidTriangle> unroll(const TriangleMesh& mesh, const Adjacency& adjacency) {
    std::vector<LaidTriangle> laid(static_cast<std::size_t>(mesh.triangle_count()));
    const auto flat = [&](int t) { return lay_flat(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)); };
    const std::vector<LayingStep> order = laying_order(adjacency, middle_triangle(mesh));
    for (std::size_t i = 1; i < order.size(); ++i) {
        const int t = order[i].triangle, from = (order[i].corner + 1) % 3, to = (order[i].corner + 2) % 3;
        const int mate = adjacency.twin(3 * t + from);
        const LaidTriangle& beside = laid[at(mate / 3)];
        const Mat22 there = flat(mate / 3), here = flat(t);
        const auto placed = [&](int k) { return Vec2(beside.origin + beside.turn * laid_corner(there, k)); };
        const Vec2 start = placed((mate % 3 + 1) % 3), end = placed(mate % 3);
        LaidTriangle& next = laid[at(t)];
        next.turn = turn_between(laid_corner(here, to) - laid_corner(here, from), end - start);
        next.origin = start - next.turn * laid_corner(here, from);
    }
    return laid;
}

}  // namespace ripstop
