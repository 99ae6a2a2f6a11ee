#include <gtest/gtest.h>

#include "ripstop/energy/deformation.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/targets.h"
#include "support/sewn.h"

namespace ripstop {
namespace compensation_test {

Tile gore() {
    return testing::gores({0.5}, 1, 4, 8).tiles[0];
}

/// The strain of the drawn surface relative to the wanted cloth, in its warp axes.
Vec3 strain_on(const Tile& tile, const Mat22& target, int t) {
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    Mat22 axes;
    axes << warp(0, t), -warp(1, t), warp(1, t), warp(0, t);
    const Mat22 C =
        cauchy_green(triangle_metric(tile.mesh.corner(t, 0), tile.mesh.corner(t, 1), tile.mesh.corner(t, 2)),
                     axes.transpose() * target);
    const Mat22 E = (C - Mat22::Identity()) / 2;
    return {E(0, 0), E(1, 1), 2 * E(0, 1)};
}

TEST(Compensation, GivesEveryTriangleTheStrainItIsToHaveAsDrawn) {
    Tile tile = gore();
    tile.compensation.strain = Points3::Random(tile.mesh.triangle_count(), 3) * 0.02;
    const std::vector<Mat22> targets = target_triangles(tile);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t)
        EXPECT_LT(
            (strain_on(tile, targets[static_cast<std::size_t>(t)], t) - Vec3(tile.compensation.strain.row(t))).norm(),
            1e-13)
            << t;
}

TEST(Compensation, OfNoStrainIsTheDrawing) {
    Tile tile = gore();
    const std::vector<Mat22> drawn = target_triangles(tile);
    const Eigen::VectorXd lengths = target_lengths(tile);
    tile.compensation.strain = Points3::Zero(tile.mesh.triangle_count(), 3);
    const std::vector<Mat22> targets = target_triangles(tile);
    for (std::size_t t = 0; t < drawn.size(); ++t) EXPECT_LT((targets[t] - drawn[t]).norm(), 1e-15);
    EXPECT_LT((target_lengths(tile) - lengths).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Compensation, TakesTheEdgesAsTheyAreToldAndShrinkageOnTop) {
    Tile tile = gore();
    const Eigen::VectorXd drawn = drawn_lengths(tile);
    tile.compensation.strain = Points3::Constant(tile.mesh.triangle_count(), 3, 0.01);
    tile.compensation.edges = Eigen::VectorXd::LinSpaced(drawn.size(), 0.99, 1.01);
    const Eigen::VectorXd told = drawn.cwiseProduct(tile.compensation.edges);
    EXPECT_LT((target_lengths(tile) - told).cwiseAbs().maxCoeff(), 1e-15);
    tile.compensation.warp = tile.compensation.weft = 0.02;
    EXPECT_LT((target_lengths(tile) - 1.02 * told).cwiseAbs().maxCoeff(), 1e-14) << "alike both ways: by that much";
}

}  // namespace compensation_test
}  // namespace ripstop
