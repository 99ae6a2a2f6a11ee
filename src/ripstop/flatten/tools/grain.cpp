#include "ripstop/flatten/tools/grain.h"

#include <Eigen/LU>

#include "ripstop/geometry/triangle.h"
#include "ripstop/tile/targets.h"

namespace ripstop {

void align_with_grain(const Tile& tile, Points2& positions) {
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Vec2 direction = Vec2::Zero();
    Vec2 centre = Vec2::Zero();
    double total = 0;
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Mat22 rest = lay_flat(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2));
        const double area = 0.5 * rest.determinant();
        const Vec2 a = positions.row(tile.mesh.triangles(t, 0));
        Mat22 flat;
        flat.col(0) = Vec2(positions.row(tile.mesh.triangles(t, 1))) - a;
        flat.col(1) = Vec2(positions.row(tile.mesh.triangles(t, 2))) - a;
        direction += area * (flat * (rest.inverse() * warp.col(t)));
        centre += area * (a + (flat.col(0) + flat.col(1)) / 3);
        total += area;
    }
    centre /= total;
    const double length = direction.norm();
    Mat22 turn = Mat22::Identity();
    if (length > 1e-9 * total) {
        direction /= length;
        turn << direction.x(), direction.y(), -direction.y(), direction.x();
    }
    positions = (positions.rowwise() - centre.transpose()) * turn.transpose();
}

}  // namespace ripstop
