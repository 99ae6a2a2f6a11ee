#include "ripstop/mesh/change/delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/predicates.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr int outside = -1;  // the vertex at infinity of a ghost triangle beyond a hull edge
constexpr double shift = 1e-9;

/// A triangle, counter-clockwise; in a ghost triangle `outside` is the last corner. Its circle holds no point right
/// of `reach`.
struct DelaunayTriangle {
    std::array<int, 3> corner;
    double reach;
};

class Triangulation {
  public:
    explicit Triangulation(const Points2& points) : at_(points) {
        const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
        for (Eigen::Index i = 0; i < at_.rows(); ++i) at_.row(i) += size * shift * Vec2(noise(2 * i), noise(2 * i + 1));
    }

    const Points2& points() const { return at_; }

    /// All triangles of the points' convex hull.
    std::vector<std::array<int, 3>> triangulate() {
        std::vector<int> order(static_cast<std::size_t>(at_.rows()));
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](int p, int q) { return at_(p, 0) < at_(q, 0); });
        start(order[0], order[1], order[2]);
        for (std::size_t k = 3; k < order.size(); ++k) insert(order[k]);
        for (const DelaunayTriangle& cell : active_) finish(cell);
        return std::move(done_);
    }

  private:
    /// Pseudo-random number between -1 and 1, the same in every run.
    static double noise(Eigen::Index seed) {
        auto x = static_cast<std::uint64_t>(seed) + 0x9e3779b97f4a7c15u;
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        x ^= x >> 31;
        return 2 * (static_cast<double>(x >> 11) / 9007199254740992.0) - 1;
    }

    Vec2 point(int i) const { return at_.row(i); }

    void start(int a, int b, int c) {
        if (orient2d(point(a), point(b), point(c)) < 0) std::swap(b, c);
        for (const auto& [p, q, r] :
             {std::array{a, b, c}, std::array{b, a, outside}, std::array{c, b, outside}, std::array{a, c, outside}})
            add(p, q, r);
    }

    void add(int a, int b, int c) {
        double reach = 1e300;
        if (c != outside) {
            const Vec2 u = point(b) - point(a), v = point(c) - point(a);
            const Vec2 centre = Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                                     u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                                (2 * cross(u, v));
            reach = point(a).x() + centre.x() + centre.norm() * (1 + 1e-6);
            if (!std::isfinite(reach)) reach = 1e300;
        }
        active_.push_back({{a, b, c}, reach});
    }

    /// Whether the circumcircle of the cell contains the point; for a ghost triangle, whether the point lies beyond
    /// its edge.
    bool holds(const DelaunayTriangle& cell, int p) const {
        const auto [a, b, c] = cell.corner;
        if (c == outside) return orient2d(point(a), point(b), point(p)) > 0;
        const Vec2 u = point(a) - point(p), v = point(b) - point(p), w = point(c) - point(p);
        return u.squaredNorm() * cross(v, w) + v.squaredNorm() * cross(w, u) + w.squaredNorm() * cross(u, v) > 0;
    }

    void finish(const DelaunayTriangle& cell) {
        if (cell.corner[2] != outside) done_.push_back(cell.corner);
    }

    void insert(int p) {
        std::set<std::pair<int, int>> rim;  // boundary of the cavity: the cells whose circles contain the point
        std::vector<DelaunayTriangle> others;
        for (const DelaunayTriangle& cell : active_) {
            if (cell.reach < point(p).x()) {
                finish(cell);
            } else if (holds(cell, p)) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const int from = cell.corner[k], to = cell.corner[(k + 1) % 3];
                    if (rim.erase({to, from}) == 0) rim.insert({from, to});
                }
            } else {
                others.push_back(cell);
            }
        }
        active_ = std::move(others);
        for (const auto& [from, to] : rim) {
            if (from == outside)
                add(to, p, outside);
            else if (to == outside)
                add(p, from, outside);
            else
                add(from, to, p);
        }
    }

    Points2 at_;
    std::vector<DelaunayTriangle> active_;
    std::vector<std::array<int, 3>> done_;
};

}  // namespace

Triangles delaunay_inside(const Points2& points, int outline) {
    Triangulation triangulation(points);
    std::vector<std::array<int, 3>> inside;
    const Points2 polygon = triangulation.points().topRows(outline);
    std::set<std::pair<int, int>> edges;
    for (const std::array<int, 3>& corner : triangulation.triangulate()) {
        const Points2& at = triangulation.points();
        const Vec2 centre = (at.row(corner[0]) + at.row(corner[1]) + at.row(corner[2])) / 3;
        if (!contains(polygon, centre)) continue;
        inside.push_back(corner);
        for (std::size_t k = 0; k < 3; ++k) edges.insert({corner[k], corner[(k + 1) % 3]});
    }
    for (int i = 0; i < outline; ++i) {
        const int next = (i + 1) % outline;
        if (!edges.contains({i, next}) || edges.contains({next, i})) return Triangles(0, 3);
    }
    std::sort(inside.begin(), inside.end());
    Triangles triangles(static_cast<Eigen::Index>(inside.size()), 3);
    for (std::size_t t = 0; t < inside.size(); ++t)
        triangles.row(static_cast<Eigen::Index>(t)) << inside[t][0], inside[t][1], inside[t][2];
    return triangles;
}

}  // namespace ripstop
