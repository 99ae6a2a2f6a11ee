#include "ripstop/pattern/drawing/lift_lines.h"

#include <Eigen/LU>
#include <algorithm>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

/// The part of a segment inside one triangle, as parameters of the segment from 0 to 1.
struct LiftedRun {
    double from = 0, to = 1;
    int triangle = 0;
};

/// Barycentric coordinates of points of the plane in a triangle of the cloth.
class FlatTriangle {
  public:
    FlatTriangle(const TriangleMesh& mesh, const Points2& flat, int triangle) : triangle_(triangle) {
        const Vec2 a = flat.row(mesh.triangles(triangle, 0)), b = flat.row(mesh.triangles(triangle, 1)),
                   c = flat.row(mesh.triangles(triangle, 2));
        Eigen::Matrix2d sides;
        sides << b - a, c - a;
        origin_ = a;
        inverse_ = sides.inverse();
    }
    Vec3 weights(const Vec2& p) const {
        const Vec2 local = inverse_ * (p - origin_);
        return {1 - local.x() - local.y(), local.x(), local.y()};
    }
    LiftedRun clip(const Vec2& from, const Vec2& to) const {
        const Vec3 start = weights(from), end = weights(to);
        LiftedRun run{0, 1, triangle_};
        for (int k = 0; k < 3; ++k) {
            const double change = end[k] - start[k];
            if (change > 0) run.from = std::max(run.from, -start[k] / change);
            if (change < 0) run.to = std::min(run.to, -start[k] / change);
            if (change == 0 && start[k] < 0) run.to = -1;
        }
        return run;
    }

  private:
    int triangle_;
    Vec2 origin_;
    Eigen::Matrix2d inverse_;
};

Points3 rows_of(const std::vector<Vec3>& points) {
    Points3 rows(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i];
    return rows;
}

}  // namespace

std::vector<Points3> lift_line(const TriangleMesh& mesh, const Points2& flat, const Points2& line) {
    constexpr double meeting = 1e-9;  // parameters of a segment this close are equal, up to rounding
    std::vector<FlatTriangle> triangles;
    for (int f = 0; f < mesh.triangle_count(); ++f) triangles.emplace_back(mesh, flat, f);

    std::vector<Points3> lifted;
    std::vector<Vec3> current;
    const auto end_line = [&] {
        if (current.size() >= 2) lifted.push_back(rows_of(current));
        current.clear();
    };
    for (Eigen::Index s = 0; s + 1 < line.rows(); ++s) {
        const Vec2 from = line.row(s), to = line.row(s + 1);
        if (from == to) continue;
        std::vector<LiftedRun> runs;
        for (const FlatTriangle& triangle : triangles)
            if (const LiftedRun run = triangle.clip(from, to); run.to > run.from + meeting) runs.push_back(run);
        std::sort(runs.begin(), runs.end(), [](const LiftedRun& a, const LiftedRun& b) { return a.from < b.from; });
        double reached = 0;
        if (runs.empty() || runs.front().from > meeting) end_line();
        for (const LiftedRun& run : runs) {
            if (run.to <= reached + meeting) continue;  // both triangles of an edge have the same run
            if (run.from > reached + meeting) end_line();
            const auto lift = [&](double share) {
                const Vec3 weights = triangles[at(run.triangle)].weights(from + share * (to - from));
                return Vec3(weights[0] * mesh.positions.row(mesh.triangles(run.triangle, 0)) +
                            weights[1] * mesh.positions.row(mesh.triangles(run.triangle, 1)) +
                            weights[2] * mesh.positions.row(mesh.triangles(run.triangle, 2)));
            };
            if (current.empty()) current.push_back(lift(std::max(run.from, reached)));
            current.push_back(lift(run.to));
            reached = run.to;
        }
        if (reached < 1 - meeting) end_line();
    }
    end_line();
    return lifted;
}

}  // namespace ripstop
