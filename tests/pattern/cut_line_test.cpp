#include "ripstop/pattern/cut_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

constexpr double steps = 5e-7;  // whole steps of a tenth of a micrometre, and the cleaning of two of them

Points2 line(std::initializer_list<std::array<double, 2>> points) {
    Points2 result(static_cast<Eigen::Index>(points.size()), 2);
    Eigen::Index i = 0;
    for (const auto& point : points) result.row(i++) << point[0], point[1];
    return result;
}

/// A rectangle of 2 m x 1 m from the lower edge on, counter-clockwise, with these allowances.
std::vector<AllowedEdge> rectangle(const std::array<double, 4>& allowance,
                                   const std::array<CornerRule, 4>& corner = {}) {
    const Points2 corners = line({{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}});
    std::vector<AllowedEdge> edges;
    for (int e = 0; e < 4; ++e) edges.push_back({corners.middleRows(e, 2), allowance[e], corner[e]});
    return edges;
}

/// A gore from the origin along +x: two arcs of `radius` that meet at an angle at both ends.
std::vector<AllowedEdge> lens(double radius, double half, double allowance, int segments, CornerRule corner = {}) {
    Points2 lower(segments + 1, 2), upper(segments + 1, 2);
    for (int i = 0; i <= segments; ++i) {
        const double angle = half * (2.0 * i / segments - 1);
        lower.row(i) << radius * std::sin(angle), radius * (std::cos(half) - std::cos(angle));
        upper.row(segments - i) << lower(i, 0), -lower(i, 1);
    }
    return {{lower, allowance, corner}, {upper, allowance, corner}};
}

double distance_to(const Points2& polygon, const Points2& points) {
    double least = 1e9;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        least = std::min(least, distance_to_outline(polygon, points.row(i)));
    return least;
}

TEST(CutLine, OfARectangleIsTheLargerRectangle) {
    const Points2 cut = make_cut_line(rectangle({0.025, 0.010, 0.025, 0.010}));
    EXPECT_NEAR(signed_area(cut), 2.020 * 1.050, steps * 7);
    EXPECT_EQ(cut.rows(), 4);
}

TEST(CutLine, WithoutAllowanceIsTheSewLine) {
    EXPECT_NEAR(signed_area(make_cut_line(rectangle({0, 0, 0, 0}))), 2, steps * 6);
    const Points2 one_edge = make_cut_line(rectangle({0.025, 0, 0, 0}));
    EXPECT_NEAR(signed_area(one_edge), 2 * 1.025, steps * 6);
}

TEST(CutLine, CutsASquareCornerAcrossAtTheAllowance) {
    const CornerRule square = CornerRule::square;
    const Points2 cut = make_cut_line(rectangle({0.02, 0.02, 0.02, 0.02}, {square, square, square, square}));
    for (const Vec2& corner : {Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(0, 1)})
        EXPECT_NEAR(distance_to_outline(cut, corner), 0.02, steps);
    // Each corner loses the tip beyond the chamfer: a right triangle with height (sqrt(2) - 1) * 0.02.
    const double height = (std::numbers::sqrt2 - 1) * 0.02;
    EXPECT_NEAR(signed_area(cut), 2.04 * 1.04 - 4 * height * height, steps * 7);
}

TEST(CutLine, LimitsTheMitreOfASharpTip) {
    // The tips of the lens open by 0.4 rad: an unlimited mitre would reach 0.025 / sin(0.2) = 126 mm.
    const Points2 cut = make_cut_line(lens(5, 0.2, 0.025, 64));
    const Vec2 tip(5 * std::sin(0.2), 0);
    EXPECT_NEAR(cut.col(0).maxCoeff() - tip.x(), 0.050, steps);
    EXPECT_GE(distance_to_outline(cut, tip), 0.025 - steps);
}

TEST(CutLine, FoldsAHemIntoTheMirrorImageOfThePiece) {
    // The lower edge is a hem; the sides lean by 0.3 rad, one outward and one inward.
    const double lean = 0.3, hem = 0.04, side = 0.01;
    const Points2 corners = line({{0, 0}, {1, 0}, {1 + std::tan(lean), 1}, {std::tan(lean), 1}, {0, 0}});
    std::vector<AllowedEdge> edges;
    for (int e = 0; e < 4; ++e)
        edges.push_back({corners.middleRows(e, 2), e == 0 ? hem : side, e == 0 ? CornerRule::fold : CornerRule::mitre});
    const Points2 cut = make_cut_line(edges);
    // What lies below the fold, turned up about it, has the piece's own cut line: no cloth looks out beside the piece.
    for (const double y : {0.005, 0.02, 0.035}) {
        const auto below = horizontal_chords(cut, -y), above = horizontal_chords(cut, y);
        ASSERT_EQ(below.size(), 1U);
        EXPECT_NEAR(below[0][0], above[0][0], 2 * steps);
        EXPECT_NEAR(below[0][1], above[0][1], 2 * steps);
    }
    EXPECT_NEAR(cut.col(1).minCoeff(), -hem, steps);
}

TEST(CutLine, KeepsItsDistanceFromEveryEdgeOfAGore) {
    for (const CornerRule corner : {CornerRule::mitre, CornerRule::square})
        for (const double allowance : {0.005, 0.025, 0.040}) {
            const std::vector<AllowedEdge> edges = lens(6, 0.6, allowance, 80, corner);
            const Points2 cut = make_cut_line(edges);
            EXPECT_TRUE(self_intersections(cut).count == 0);
            for (const AllowedEdge& edge : edges) {
                EXPECT_NEAR(distance_to(cut, edge.sew_line), allowance, steps);
                for (Eigen::Index i = 0; i < edge.sew_line.rows(); ++i)
                    EXPECT_TRUE(contains(cut, Vec2(edge.sew_line.row(i))));
            }
            // Turning by 2 * 0.6 / 80 rad a segment, the mitres between the segments stand out by less than 1e-4 of it.
            const Points2 lower = edges[0].sew_line;
            double furthest = 0;
            for (Eigen::Index i = 20; i < 60; ++i)
                furthest = std::max(furthest, distance_to_outline(cut, lower.row(i)));
            EXPECT_LT(furthest, allowance * (1 + 1e-4) + steps);
        }
}

TEST(CutLine, ClosesOverANarrowNotchOfTheSewLine) {
    const Points2 corners = line({{0, 0}, {1, 0}, {1, 1}, {0.52, 1}, {0.5, 0.5}, {0.48, 1}, {0, 1}, {0, 0}});
    std::vector<AllowedEdge> edges;
    for (Eigen::Index e = 0; e + 1 < corners.rows(); ++e) edges.push_back({corners.middleRows(e, 2), 0.03});
    const Points2 cut = make_cut_line(edges);
    EXPECT_EQ(self_intersections(cut).count, 0);
    EXPECT_TRUE(contains(cut, Vec2(0.5, 0.9)));
}

TEST(CutLine, HasNoHoleWhereAllowancesMeet) {
    // A hook whose ends come within twice the allowance of each other.
    const Points2 corners = line(
        {{0, 0}, {1, 0}, {1, 0.2}, {0.2, 0.2}, {0.2, 0.8}, {1, 0.8}, {1, 0.25}, {1.2, 0.25}, {1.2, 1}, {0, 1}, {0, 0}});
    std::vector<AllowedEdge> edges;
    for (Eigen::Index e = 0; e + 1 < corners.rows(); ++e) edges.push_back({corners.middleRows(e, 2), 0.04});
    const Points2 cut = make_cut_line(edges);
    EXPECT_EQ(self_intersections(cut).count, 0);
    for (Eigen::Index i = 0; i < corners.rows(); ++i) EXPECT_TRUE(contains(cut, Vec2(corners.row(i))));
}

}  // namespace
}  // namespace ripstop
