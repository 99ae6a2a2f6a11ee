#include "ripstop/mesh/change/flips.h"

#include "ripstop/geometry/triangle.h"

namespace ripstop {

int count_flipped(const Triangles& triangles, const Points2& positions) {
    int count = 0;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
        const double area =
            signed_area(positions.row(triangles(t, 0)), positions.row(triangles(t, 1)), positions.row(triangles(t, 2)));
        if (!(area > 0)) ++count;
    }
    return count;
}

}  // namespace ripstop
