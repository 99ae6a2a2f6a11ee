#include "ripstop/io/svg/values/svg_path.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"

namespace ripstop {
namespace svg_path_test {

constexpr double pi = std::numbers::pi;

double length_of(const std::vector<Vec2>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length;
}

std::vector<Vec2> points_of(const std::string& d, const SvgSampling& sampling = {1e-4, 1}) {
    return sampled(svg_path(d, "p").at(0), Eigen::Affine2d::Identity(), sampling);
}

TEST(SvgPath, ReadsFlagsThatNothingParts) {
    // Three notations for a quarter circle of radius 2 about (8, 8).
    for (const char* d : {"M10 8A2 2 0 0 1 8 10", "M10 8a2 2 0 01-2 2", "M10,8a2,2,0,0,1-2,2"}) {
        const SvgSegment arc = svg_path(d, "p").at(0).segments.at(0);
        ASSERT_EQ(arc.kind, SvgSegment::Kind::arc) << d;
        EXPECT_LT((arc.centre - Vec2(8, 8)).norm(), 1e-12) << d;
        EXPECT_NEAR(arc.sweep, pi / 2, 1e-12) << d;
        EXPECT_EQ(arc.to, Vec2(8, 10)) << d;
    }
    // `0012 2`: two flags and the number 12.
    EXPECT_EQ(svg_path("M0 0a1 1 0 0012 2 1 1 0 10-.5.5", "p").at(0).segments.at(1).to, Vec2(11.5, 2.5));
    EXPECT_THROW(svg_path("M0 0a2 2 0 2 1 1 1", "p"), InputError);
}

TEST(SvgPath, TakesEachOfTheFourArcsThroughTwoPoints) {
    // Radius 5 through (0, 0) and (8, 0): the centres are (4, 3) and (4, -3), the half angle asin(4/5).
    const double small = 2 * std::asin(0.8);
    for (const bool is_large : {false, true})
        for (const bool is_positive : {false, true}) {
            const SvgSegment arc = svg_arc({0, 0}, {5, 5}, 0.3, is_large, is_positive, {8, 0});
            EXPECT_NEAR(std::abs(arc.sweep), is_large ? 2 * pi - small : small, 1e-12);
            EXPECT_EQ(arc.sweep > 0, is_positive);
            EXPECT_NEAR(std::abs(arc.centre.y()), 3, 1e-12);
            for (const double t : {arc.start_angle, arc.start_angle + arc.sweep}) {
                const Vec2 end = arc.centre + arc.axes * Vec2(std::cos(t), std::sin(t));
                EXPECT_LT((end - (t == arc.start_angle ? Vec2(0, 0) : Vec2(8, 0))).norm(), 1e-12);
            }
        }
}

TEST(SvgPath, GrowsRadiiThatDoNotReachAndDrawsALineForNone) {
    const SvgSegment half = svg_arc({0, 0}, {1, 2}, 0, false, true, {10, 0});
    EXPECT_LT((half.centre - Vec2(5, 0)).norm(), 1e-12);
    EXPECT_NEAR(half.axes(0, 0), 5, 1e-12);
    EXPECT_NEAR(half.axes(1, 1), 10, 1e-12);
    EXPECT_EQ(svg_arc({0, 0}, {0, 2}, 0, false, true, {10, 0}).kind, SvgSegment::Kind::line);
    EXPECT_EQ(svg_arc({1, 0}, {2, 2}, 0, true, true, {1, 0}).kind, SvgSegment::Kind::line);
}

TEST(SvgPath, SamplesACurveWithinItsChordErrorWhateverItsSize) {
    // A circle made of four cubics (within 2.8e-4 of the radius) and of arcs.
    for (const double radius : {1.0, 60.0, 600.0, 6000.0}) {
        for (const double error : {0.05, 0.002}) {
            const SvgSampling sampling{error, 1};
            const SvgRun circle = svg_ellipse({0, 0}, {radius, radius});
            const std::vector<Vec2> round = sampled(circle, Eigen::Affine2d::Identity(), sampling);
            double farthest = 0;
            for (std::size_t i = 1; i < round.size(); ++i) {
                EXPECT_NEAR(round[i].norm(), radius, 1e-12 * radius);
                farthest = std::max(farthest, radius - ((round[i] + round[i - 1]) / 2).norm());
            }
            EXPECT_LE(farthest, error * (1 + 1e-6)) << radius;
            EXPECT_GE(farthest, 0.5 * error) << "not finer than needed";

            const double k = 0.5522847498 * radius;
            const SvgRun quarter{{radius, 0}, {svg_cubic({radius, k}, {k, radius}, {0, radius})}, false};
            const std::vector<Vec2> chords = sampled(quarter, Eigen::Affine2d::Identity(), sampling);
            const std::vector<Vec2> fine = sampled(quarter, Eigen::Affine2d::Identity(), {error / 1000, 1});
            // A chord of length c on a curve of radius r has the sagitta c² / 8r.
            for (std::size_t i = 1; i < chords.size(); ++i)
                EXPECT_LE((chords[i] - chords[i - 1]).squaredNorm() / (8 * radius), error * 1.01);
            EXPECT_NEAR(length_of(chords), length_of(fine), 8.0 / 3 * error);
            EXPECT_LT(chords.size(), 3 + 2 * std::sqrt(radius / error))
                << "Wang's bound is within twice of what is needed";
        }
    }
}

TEST(SvgPath, SamplesAtTheScaleOfThePage) {
    Eigen::Affine2d motion = Eigen::Affine2d::Identity();
    motion.linear() << 300, 0, 0, 20;
    const std::vector<Vec2> points = sampled(svg_ellipse({0, 0}, {1, 1}), motion, {0.05, 1});
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 a = points[i - 1], b = points[i], middle = (a + b) / 2;
        // The middle of a chord projected onto the ellipse.
        const double out = Vec2(middle.x() / 300, middle.y() / 20).norm();
        EXPECT_LE((middle / out - middle).norm(), 0.05 * (1 + 1e-6));
    }
    EXPECT_GT(points.size(), 100U);
}

TEST(SvgPath, MirrorsTheControlOfSmoothCurvesOnlyAfterTheirOwnKind) {
    const auto first_control = [](const std::string& d, std::size_t i) {
        return svg_path(d, "p").at(0).segments.at(i).first_control;
    };
    EXPECT_EQ(first_control("M0 0C0 1 1 2 2 2S4 4 5 5", 1), Vec2(3, 2));
    EXPECT_EQ(first_control("M0 0L2 2S4 4 5 5", 1), Vec2(2, 2));
    EXPECT_EQ(first_control("M0 0Q1 1 2 2S4 4 5 5", 1), Vec2(2, 2)) << "Q is no cubic";
    // A parabola: the control points of the cubic are two thirds of the way to the quadratic's, which t mirrors.
    EXPECT_LT((first_control("M0 0q3 0 3 3t3 3", 1) - Vec2(3, 5)).norm(), 1e-12);
    EXPECT_LT((first_control("M0 0q3 0 3 3t3 3 3 3", 2) - Vec2(8, 6)).norm(), 1e-12);
}

TEST(SvgPath, RoundsTheCornersOfARectangle) {
    // w h minus the corners' (4 - pi) r²; radii are at most half of the side.
    const auto area = [](const Vec2& radii) {
        const std::vector<Vec2> p =
            sampled(svg_rectangle({1, 2}, {30, 20}, radii), Eigen::Affine2d::Identity(), {1e-5, 1});
        double twice = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec2 a = p[i], b = p[(i + 1) % p.size()];
            twice += a.x() * b.y() - a.y() * b.x();
        }
        return twice / 2;
    };
    EXPECT_DOUBLE_EQ(area({0, 5}), 600);
    EXPECT_NEAR(area({5, 5}), 600 - (4 - pi) * 25, 1e-3);
    EXPECT_NEAR(area({5, 2}), 600 - (4 - pi) * 10, 1e-3);
    EXPECT_NEAR(area({100, 100}), pi * 150, 1e-3) << "an ellipse";
}

TEST(SvgPath, ReadsNumbersAsTheGrammarHasThem) {
    const std::vector<Vec2> points = points_of("M.5.5-1-2l1e1.5e1,1.E-1+2");
    ASSERT_EQ(points.size(), 4U);
    EXPECT_EQ(points[1], Vec2(-1, -2));
    EXPECT_EQ(points[2], Vec2(9, 3));
    EXPECT_EQ(points[3], Vec2(9.1, 5));
}

}  // namespace svg_path_test
}  // namespace ripstop
