#include "ripstop/flatten/tools/step_filter.h"

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/triangle.h"

namespace ripstop {

double longest_step(const Triangles& triangles, const Eigen::VectorXd& u, const Eigen::VectorXd& d) {
    const auto at = [](const Eigen::VectorXd& x, int vertex) -> Vec2 { return x.segment<2>(2 * vertex); };
    double longest = 1 / 0.9;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
        const int i = triangles(t, 0), j = triangles(t, 1), k = triangles(t, 2);
        const Vec2 a = at(u, j) - at(u, i), b = at(u, k) - at(u, i);
        const Vec2 da = at(d, j) - at(d, i), db = at(d, k) - at(d, i);
        // smallest positive root of det(s) = c0 + c1 s + c2 s^2
        const double c0 = cross(a, b), c1 = cross(a, db) + cross(da, b), c2 = cross(da, db);
        const double discriminant = c1 * c1 - 4 * c0 * c2;
        if (discriminant < 0) continue;
        const double q = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
        for (const double root : {q != 0 ? c0 / q : -1, c2 != 0 ? q / c2 : -1})
            if (root > 0) longest = std::min(longest, root);
    }
    return 0.9 * longest;
}

}  // namespace ripstop
