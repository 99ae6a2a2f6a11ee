#include "ripstop/geometry/fair_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ripstop {
namespace fair_curve_test {

constexpr double pi = std::numbers::pi;

/// Points on a circle of 1 m, every second one `height` farther out.
Points2 toothed_circle(int count, double height) {
    Points2 points(count, 2);
    for (int i = 0; i < count; ++i) {
        const double radius = 1 + (i % 2 == 0 ? height / 2 : -height / 2), angle = 2 * pi * i / count;
        points.row(i) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return points;
}

TEST(FairCurve, OfACircleWithTeethIsTheCircle) {
    for (const int count : {40, 80, 200})
        for (const double share : {0.2, 0.5, 0.9}) {  // of an edge
            const Points2 chain = toothed_circle(count, share * 2 * pi / count);
            const FairCurve curve(layout_of(chain, true));
            EXPECT_NEAR(curve.line().length, 2 * pi, 1e-3 * 2 * pi) << count << " " << share;
            const Points2 fair = fair_points(chain, true);
            EXPECT_LT((fair.rowwise().norm().array() - 1).abs().maxCoeff(), 0.05 * 2 * pi / count) << count << share;
        }
}

TEST(FairCurve, LeavesCirclesAndStraightLinesWhereTheyAre) {
    const Points2 circle = toothed_circle(60, 0);
    EXPECT_LT((fair_points(circle, true) - circle).rowwise().norm().maxCoeff(), 1e-6);
    EXPECT_LT(FairCurve(layout_of(circle, true)).line().moves.rowwise().norm().maxCoeff(), 1e-3 * 2 * pi / 60);
    EXPECT_NEAR(FairCurve(layout_of(circle, true)).line().length, 2 * pi, 1e-5 * 2 * pi);
    Points2 line(20, 2);
    for (int i = 0; i < 20; ++i) line.row(i) << 0.3 * i + 0.1 * std::sin(i), 1;
    const FairCurve straight(layout_of(line, false));
    EXPECT_NEAR(straight.line().length, line(19, 0) - line(0, 0), 1e-9);
    EXPECT_NEAR(straight.line().area_on_left, 0, 1e-9);
}

TEST(FairCurve, KeepsTheEndsOfAnOpenChain) {
    Points2 chain(24, 2);
    for (int i = 0; i < 24; ++i) chain.row(i) << i, i % 2 == 0 ? 0.4 : -0.4;
    const Points2 fair = fair_points(chain, false);
    EXPECT_EQ(fair.row(0), chain.row(0));
    EXPECT_EQ(fair.row(23), chain.row(23));
    const Points2 steps = fair.bottomRows(23) - fair.topRows(23);
    EXPECT_LT(steps.col(1).cwiseAbs().maxCoeff(), 0.2);  // the chain has 0.8
    EXPECT_GT(steps.col(0).minCoeff(), 0.5);
}

TEST(FairCurve, OfAnImageWithTheSameLengthsAndTurnsIsAsLong) {
    const Points2 chain = toothed_circle(50, 0.08);
    ChainLayout layout = layout_of(chain, true);
    const FairCurve curve(layout);
    Points2 turned(50, 2);
    for (int i = 0; i < 50; ++i) turned.row(i) << 3 - chain(i, 1), 5 + chain(i, 0);
    EXPECT_NEAR(curve.of_image(layout_of(turned, true)).length, curve.line().length, 1e-9);
    // Teeth that fold back at a hundredth: the same edges reach farther.
    layout.turns *= 0.99;
    EXPECT_GT(curve.of_image(layout).length, curve.line().length * 1.0005);
}

}  // namespace fair_curve_test
}  // namespace ripstop
