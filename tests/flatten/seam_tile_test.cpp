#include "ripstop/flatten/seam/seam_tile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fabrics.h"
#include "support/finite_difference.h"
#include "support/sewn.h"

namespace ripstop {
namespace seam_tile_test {

using Vector = Eigen::VectorXd;

/// A gore between two others, with seams slightly longer than drawn.
struct Case {
    Envelope envelope = testing::gores({0.6, 0.4}, 3, 4, 8);
    SeamStretch stretch = find_seam_stretch(envelope);
    SeamTile tile{envelope.tiles[1], testing::uneven_cloth(30), stretch.tiles[1], 3e-3};
    Vector h = Vector::NullaryExpr(static_cast<Eigen::Index>(stretch.tiles[1].intervals.size()), [](Eigen::Index i) {
        return 0.004 + 0.002 * std::sin(3.0 * static_cast<double>(i));
    });
};

TEST(SeamTile, GradientIsThatOfItsLeastEnergy) {
    Case c;
    ASSERT_TRUE(c.tile.hold(c.h));
    const Vector gradient = c.tile.gradient();
    const auto energy = [&](const Vector& h) {
        EXPECT_TRUE(c.tile.hold(h));
        return Vector::Constant(1, c.tile.energy()).eval();
    };
    const Vector measured = testing::jacobian(energy, c.h).transpose();
    EXPECT_LT((measured - gradient).norm(), 1e-5 * gradient.norm());
}

TEST(SeamTile, HessianIsThatOfItsLeastEnergy) {
    Case c;
    ASSERT_TRUE(c.tile.hold(c.h));
    const Eigen::MatrixXd hessian = c.tile.linearize();
    EXPECT_TRUE(c.tile.exact());
    const auto gradient = [&](const Vector& h) {
        EXPECT_TRUE(c.tile.hold(h));
        return c.tile.gradient();
    };
    EXPECT_LT((testing::jacobian(gradient, c.h) - hessian).norm(), 1e-5 * hessian.norm());
    EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm());
}

TEST(SeamTile, PredictsToSecondOrderWhereAChangeTakesIt) {
    Case c;
    ASSERT_TRUE(c.tile.hold(c.h));
    const Vector change = Vector::LinSpaced(c.h.size(), -0.002, 0.003);
    c.tile.linearize();
    c.tile.aim(change);
    const int before = c.tile.factorizations();
    const double aimed = c.tile.attempt(0.5);
    EXPECT_LE(c.tile.factorizations() - before, 2);  // Newton from an error of about 1e-6
    ASSERT_TRUE(c.tile.hold(c.h + 0.5 * change));
    EXPECT_NEAR(aimed, c.tile.energy(), 1e-9 * aimed);
}

TEST(SeamTile, SaysWhereItsEdgesCannotBeHeld) {
    Case c;
    Vector h = c.h;
    h[0] = 100;  // one edge is longer than all others together
    EXPECT_FALSE(c.tile.hold(h));
}

}  // namespace seam_tile_test
}  // namespace ripstop
