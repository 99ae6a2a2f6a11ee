#include "support/closed_tiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "support/shapes.h"

namespace ripstop::testing {

TriangleMesh polygon_tube(const Points2& polygon, double height, int columns, int rows) {
    const int sides = static_cast<int>(polygon.rows()), around = sides * columns;
    return grid(around, rows, [&](double u, double v) {
        const int at = static_cast<int>(std::lround(u * around));
        const int side = at / columns % sides;
        const double share = double(at % columns) / columns;
        const Vec2 p = (1 - share) * polygon.row(side) + share * polygon.row((side + 1) % sides);
        return Vec3(p.x(), p.y(), height * v);
    });
}

TriangleMesh round_tube(double radius, double height, int sides, int rows) {
    Points2 polygon(sides, 2);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        polygon.row(i) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return polygon_tube(polygon, height, 1, rows);
}

TriangleMesh box_tube(double width, double depth, double height, int columns, int rows) {
    Points2 polygon(4, 2);
    polygon << 0, 0, width, 0, width, depth, 0, depth;
    return polygon_tube(polygon, height, columns, rows);
}

TriangleMesh helical_tube(double radius, double height, int sides, int rows, int slip) {
    // Upright lines at every side from the lower to the upper edge of the parallelogram; at its two tips they are
    // points.
    std::vector<Vec3> points;
    std::map<std::pair<int, int>, int> number;
    for (int i = 0; i <= sides + slip; ++i) {
        const double low = std::max(0, i - sides) * height / slip, high = std::min(i, slip) * height / slip;
        const double angle = 2 * std::numbers::pi * i / sides;
        const bool is_tip = i == 0 || i == sides + slip;
        for (int j = 0; j <= rows; ++j) {
            if (!is_tip || j == 0)
                points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), low + (high - low) * j / rows);
            number[{i, j}] = static_cast<int>(points.size()) - 1;
        }
    }
    std::vector<Eigen::RowVector3i> triangles;
    const auto add = [&](int a, int b, int c) {
        if (a != b && b != c && c != a) triangles.emplace_back(a, b, c);
    };
    for (int i = 0; i < sides + slip; ++i)
        for (int j = 0; j < rows; ++j) {
            add(number[{i, j}], number[{i + 1, j}], number[{i + 1, j + 1}]);
            add(number[{i, j}], number[{i + 1, j + 1}], number[{i, j + 1}]);
        }
    TriangleMesh mesh;
    mesh.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t v = 0; v < points.size(); ++v) mesh.positions.row(static_cast<Eigen::Index>(v)) = points[v];
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t) mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
    return mesh;
}

TriangleMesh bulged(TriangleMesh mesh, double share) {
    const double low = mesh.positions.col(2).minCoeff(), high = mesh.positions.col(2).maxCoeff();
    for (Eigen::Index v = 0; v < mesh.positions.rows(); ++v) {
        const double s = 2 * (mesh.positions(v, 2) - low) / (high - low) - 1;
        mesh.positions.row(v).head<2>() *= 1 + share * (1 - s * s);
    }
    return mesh;
}

}  // namespace ripstop::testing
