#include "ripstop/geometry/simplify.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ripstop {
namespace simplify_test {

Points2 arc(int segments, double angle) {
    Points2 line(segments + 1, 2);
    for (int i = 0; i <= segments; ++i) line.row(i) << std::cos(angle * i / segments), std::sin(angle * i / segments);
    return line;
}

double length(const Points2& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1)).rowwise().norm().sum();
}

double distance(const Vec2& p, const Points2& line) {
    double least = 1e9;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
        const Vec2 a = line.row(i), way = Vec2(line.row(i + 1)) - a;
        const double t = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + t * way - p).norm());
    }
    return least;
}

TEST(Simplified, KeepsEveryPointWithinTheToleranceAndBothEnds) {
    const Points2 line = arc(400, 2);
    for (const double tolerance : {1e-5, 1e-4, 1e-3}) {
        const Points2 less = simplified(line, tolerance);
        EXPECT_EQ(less.row(0), line.row(0));
        EXPECT_EQ(less.row(less.rows() - 1), line.row(400));
        for (Eigen::Index i = 0; i <= 400; ++i) EXPECT_LE(distance(line.row(i), less), tolerance * (1 + 1e-9));
        // A chord over the angle t has the sagitta 1 - cos(t / 2), about t^2 / 8. So 2 / t segments suffice, and
        // there are less than twice that.
        const double fewest = 2 / std::sqrt(8 * tolerance);
        EXPECT_LT(static_cast<double>(less.rows()), 2 * fewest + 2);
        // it is too short by t^2 / 24 = tolerance / 3 of its length
        EXPECT_GT(length(less), length(line) * (1 - tolerance / 2));
    }
}

TEST(Simplified, LeavesAStraightLineItsEnds) {
    Points2 line(5, 2);
    line << 0, 0, 1, 1, 2, 2, 3, 3, 4, 4;
    EXPECT_EQ(simplified(line, 1e-9).rows(), 2);
}

TEST(Simplified, GoesRoundAClosedLine) {
    const Points2 circle = arc(90, 2 * 3.14159265358979323846);
    const Points2 less = simplified(circle, 1e-3);
    EXPECT_GE(less.rows(), 30);
    for (Eigen::Index i = 0; i <= 90; ++i) EXPECT_LE(distance(circle.row(i), less), 1.001e-3);
}

TEST(Simplified, TakesLinesOfAnyLength) {
    for (const Eigen::Index rows : {0, 1, 2}) {
        const Points2 line = Points2::Random(rows, 2);
        EXPECT_EQ(simplified(line, 1), line);
    }
}

}  // namespace simplify_test
}  // namespace ripstop
