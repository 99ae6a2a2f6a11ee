#include "ripstop/measure/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace judge_test {

const Fabric fabric;

Tile square() {
    return make_tile("square", testing::rectangle(1, 1, 4, 4), {.warp = Vec3::UnitX()});
}

std::vector<std::string> codes(const Verdict& verdict) {
    std::vector<std::string> result;
    for (const Finding& finding : verdict.findings) result.push_back(finding.code);
    return result;
}

Verdict judged(const Tile& tile, const Points2& flat, Termination termination = Termination::converged) {
    return judge(tile, measure_bounds(tile), {flat, {termination, 1, 0, "test"}}, measure_accuracy(tile, flat, fabric),
                 tolerances_of(fabric));
}

TEST(Accuracy, OfAStretchedSquareByHand) {
    const Tile tile = square();
    const Points2 flat = tile.mesh.positions.leftCols(2) * Eigen::Vector2d(1.01, 1).asDiagonal();
    const Accuracy accuracy = measure_accuracy(tile, flat, fabric);
    EXPECT_NEAR(accuracy.area, 1, 1e-15);
    EXPECT_NEAR(accuracy.area_error, 0.01, 1e-14);
    EXPECT_NEAR(accuracy.area_error_abs, 0.01, 1e-14);
    EXPECT_NEAR(accuracy.perimeter_error, 0.005, 1e-14);
    EXPECT_NEAR(accuracy.boundary_error_abs, 0.005, 1e-14);
    EXPECT_NEAR(accuracy.boundary_error_max, 0.01, 1e-14);
    EXPECT_NEAR(accuracy.warp_strain_min, 1 / 1.01 - 1, 1e-14);
    EXPECT_NEAR(accuracy.warp_strain_max, 1 / 1.01 - 1, 1e-14);
    EXPECT_NEAR(accuracy.weft_strain_max, 0, 1e-14);
    ASSERT_EQ(accuracy.chains.size(), 4u);
    EXPECT_NEAR(accuracy.chains[0].error(), 0.01, 1e-14);
    EXPECT_NEAR(accuracy.chains[1].error(), 0, 1e-14);
    const double strain = 0.5 * (1 / (1.01 * 1.01) - 1);
    EXPECT_NEAR(accuracy.energy, 0.5 * 1000 * strain * strain * 1.01, 1e-12);
    EXPECT_EQ(accuracy.flipped, 0);
    EXPECT_EQ(accuracy.overlaps, 0);
}

/// The number of findings on chains of a triangle with a blunt tip, whose edge is twice as long on the cloth.
std::size_t chain_findings(double tip) {
    TriangleMesh mesh = testing::rectangle(1, 1, 1, 1);
    mesh.positions.row(2) << 0.5 - tip / 2, 1, 0;
    mesh.positions.row(3) << 0.5 + tip / 2, 1, 0;
    TileOptions options;
    options.warp = Vec3::UnitX();
    options.corners = {{0, 0, 0}, {1, 0, 0}, mesh.positions.row(2).transpose(), mesh.positions.row(3).transpose()};
    const Tile tile = make_tile("blunt", mesh, options);
    EXPECT_EQ(tile.chains.size(), 4U);
    Points2 flat = mesh.positions.leftCols(2);
    flat(2, 0) -= tip / 2;
    flat(3, 0) += tip / 2;
    const std::vector<std::string> found = codes(judged(tile, flat));
    return static_cast<std::size_t>(std::count(found.begin(), found.end(), "chain"));
}

TEST(Judge, AsksNoMoreOfAnEdgeThanAPlottersStep) {
    EXPECT_EQ(chain_findings(0.013 * millimetre), 0U);
    EXPECT_EQ(chain_findings(0.1 * millimetre), 1U);
}

TEST(Accuracy, AllEdgesByHandOnTwoTriangles) {
    const Tile tile = make_tile("t", testing::rectangle(1, 1, 1, 1), {.warp = Vec3::UnitX()});
    const Points2 flat = tile.mesh.positions.leftCols(2) * 1.1;
    const Accuracy accuracy = measure_accuracy(tile, flat, fabric);
    EXPECT_NEAR(accuracy.edge_error_abs, 0.1, 1e-14);
    EXPECT_NEAR(accuracy.area_error, 0.21, 1e-14);
}

TEST(Judge, PassesAnIsometry) {
    const Tile tile = square();
    const Verdict verdict = judged(tile, tile.mesh.positions.leftCols(2));
    EXPECT_TRUE(verdict.manufacturable());
}

TEST(Judge, AnUnjudgedTileIsNotManufacturable) {
    EXPECT_FALSE(Verdict{}.manufacturable());
}

TEST(Judge, NamesEveryLimitThatIsBroken) {
    const Tile tile = square();
    const Points2 wide = tile.mesh.positions.leftCols(2) * Eigen::Vector2d(1.03, 1).asDiagonal();
    EXPECT_EQ(codes(judged(tile, wide)),
              (std::vector<std::string>{"area", "perimeter", "chain", "chain", "warp_strain"}));
    Mat22 lean;
    lean << 1, 0.3, 0, 1;
    const Points2 leaning = tile.mesh.positions.leftCols(2) * lean.transpose();
    const Verdict verdict = judged(tile, leaning);
    EXPECT_EQ(codes(verdict), (std::vector<std::string>{"perimeter", "chain", "chain", "weft_strain", "shear"}));
    EXPECT_NEAR(verdict.findings.back().value, std::atan(0.3) / degree, 1e-9);
    EXPECT_DOUBLE_EQ(verdict.findings.back().limit, fabric.shear_limit / degree);
}

TEST(Judge, JustInsideAndJustOutsideTheLengthTolerance) {
    const Tile tile = square();
    const auto scaled = [&](double error) { return Points2(tile.mesh.positions.leftCols(2) * (1 + error)); };
    EXPECT_TRUE(judged(tile, scaled(0.000999)).manufacturable());
    EXPECT_FALSE(judged(tile, scaled(0.001001)).manufacturable());
}

TEST(Judge, RefusesFlipsOverlapsAndMissingResults) {
    const Tile tile = square();
    Points2 flat = tile.mesh.positions.leftCols(2);
    flat.row(12) << 2, 2;
    const auto found = codes(judged(tile, flat));
    EXPECT_EQ(found[0], "flipped");
    EXPECT_EQ(found[1], "overlap");
    EXPECT_EQ(codes(judged(tile, tile.mesh.positions.leftCols(2), Termination::failed)).front(), "unsolved");
    EXPECT_EQ(codes(judged(tile, tile.mesh.positions.leftCols(2), Termination::iteration_limit)).front(), "unsolved");
}

TEST(Judge, NotANumberIsNeverManufacturable) {
    const Tile tile = square();
    Points2 flat = tile.mesh.positions.leftCols(2);
    flat(5, 0) = std::nan("");
    EXPECT_FALSE(judged(tile, flat).manufacturable());
}

}  // namespace judge_test
}  // namespace ripstop
