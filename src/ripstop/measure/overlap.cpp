#include "ripstop/measure/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

using Corners = std::array<Vec2, 3>;

Corners corners(const Triangles& triangles, const Points2& flat, int t) {
    Corners result = {flat.row(triangles(t, 0)), flat.row(triangles(t, 1)), flat.row(triangles(t, 2))};
    if (signed_area(result[0], result[1], result[2]) < 0) std::swap(result[1], result[2]);
    return result;
}

/// Whether an edge of the counter-clockwise triangle `a` has all of `b` on its outer side, within rounding.
bool separated_by_edge_of(const Corners& a, const Corners& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 edge = a[(k + 1) % 3] - a[k];
        double inside = -std::numeric_limits<double>::infinity();
        double reach = edge.norm();
        for (const Vec2& point : b) {
            inside = std::max(inside, cross(edge, point - a[k]));
            reach = std::max(reach, (point - a[k]).norm());
        }
        if (inside <= 1e-13 * edge.norm() * reach) return true;
    }
    return false;
}

/// A grid over the flat positions with square cells of about a triangle's size.
class Grid {
  public:
    Grid(const Triangles& triangles, const Points2& flat) : lower_(flat.colwise().minCoeff()) {
        const Vec2 extent = Vec2(flat.colwise().maxCoeff()) - lower_;
        double mean = 0;
        for (Eigen::Index t = 0; t < triangles.rows(); ++t) mean += size(triangles, flat, t);
        mean /= static_cast<double>(triangles.rows());
        const double floor = extent.maxCoeff() / 4096;
        cell_ = std::max({mean, floor, 1e-300});
        columns_ = cells(extent.x());
        rows_ = cells(extent.y());
    }
    struct Range {
        int x0, x1, y0, y1;
    };
    Range range(const Corners& c) const {
        const Vec2 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]) - lower_;
        const Vec2 high = c[0].cwiseMax(c[1]).cwiseMax(c[2]) - lower_;
        return {index(low.x(), columns_), index(high.x(), columns_), index(low.y(), rows_), index(high.y(), rows_)};
    }
    std::size_t cell(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
    }
    std::size_t count() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }

  private:
    static double size(const Triangles& triangles, const Points2& flat, Eigen::Index t) {
        const Points2 c = flat({triangles(t, 0), triangles(t, 1), triangles(t, 2)}, Eigen::all);
        return (c.colwise().maxCoeff() - c.colwise().minCoeff()).maxCoeff();
    }
    int cells(double extent) const { return std::clamp(static_cast<int>(extent / cell_) + 1, 1, 4097); }
    int index(double at, int count) const { return std::clamp(static_cast<int>(at / cell_), 0, count - 1); }

    Vec2 lower_;
    double cell_ = 1;
    int columns_ = 1, rows_ = 1;
};

}  // namespace

std::vector<std::array<int, 2>> overlapping_triangles(const Triangles& triangles, const Points2& flat) {
    std::vector<std::array<int, 2>> pairs;
    if (triangles.rows() == 0 || !flat.allFinite()) return pairs;
    const Grid grid(triangles, flat);
    std::vector<std::vector<int>> cells(grid.count());
    std::vector<int> met(static_cast<std::size_t>(triangles.rows()), -1);
    for (int t = 0; t < triangles.rows(); ++t) {
        const Corners c = corners(triangles, flat, t);
        const auto range = grid.range(c);
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0; x <= range.x1; ++x) {
                std::vector<int>& here = cells[grid.cell(x, y)];
                for (const int other : here) {
                    if (met[at(other)] == t) continue;
                    met[at(other)] = t;
                    const Corners d = corners(triangles, flat, other);
                    if (!separated_by_edge_of(c, d) && !separated_by_edge_of(d, c)) pairs.push_back({other, t});
                }
                here.push_back(t);
            }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace ripstop
