#include "ripstop/pattern/cut/cut_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace cut_line_test {

constexpr double steps = 5e-7;  // steps of 0.1 micrometre, and the removal of points within two of them

Points2 cut_points(const std::vector<AllowedEdge>& edges) {
    return make_cut_line(edges).points;
}

Points2 line(std::initializer_list<std::array<double, 2>> points) {
    Points2 result(static_cast<Eigen::Index>(points.size()), 2);
    Eigen::Index i = 0;
    for (const auto& point : points) result.row(i++) << point[0], point[1];
    return result;
}

/// A rectangle of 2 m x 1 m with these allowances, counter-clockwise from the lower edge.
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
    const Points2 cut = cut_points(rectangle({0.025, 0.010, 0.025, 0.010}));
    EXPECT_NEAR(signed_area(cut), 2.020 * 1.050, steps * 7);
    EXPECT_EQ(cut.rows(), 4);
}

TEST(CutLine, WithoutAllowanceIsTheSewLine) {
    EXPECT_NEAR(signed_area(cut_points(rectangle({0, 0, 0, 0}))), 2, steps * 6);
    const Points2 one_edge = cut_points(rectangle({0.025, 0, 0, 0}));
    EXPECT_NEAR(signed_area(one_edge), 2 * 1.025, steps * 6);
}

TEST(CutLine, CutsASquareCornerAcrossAtTheAllowance) {
    const CornerRule square = CornerRule::square;
    const Points2 cut = cut_points(rectangle({0.02, 0.02, 0.02, 0.02}, {square, square, square, square}));
    for (const Vec2& corner : {Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(0, 1)})
        EXPECT_NEAR(distance_to_outline(cut, corner), 0.02, steps);
    // Each corner loses the tip beyond the chamfer, a right triangle of height (sqrt(2) - 1) * 0.02.
    const double height = (std::numbers::sqrt2 - 1) * 0.02;
    EXPECT_NEAR(signed_area(cut), 2.04 * 1.04 - 4 * height * height, steps * 7);
}

TEST(CutLine, LimitsTheMitreOfASharpTip) {
    // The tips of the lens open by 0.4 rad: an unlimited mitre would extend 0.025 / sin(0.2) = 126 mm.
    const Points2 cut = cut_points(lens(5, 0.2, 0.025, 64));
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
    const Points2 cut = cut_points(edges);
    // The part below the fold, mirrored upwards, matches the piece's own cut line, so no cloth shows beside the
    // piece.
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
            const Points2 cut = cut_points(edges);
            EXPECT_TRUE(self_intersections(cut).count == 0);
            for (const AllowedEdge& edge : edges) {
                EXPECT_NEAR(distance_to(cut, edge.sew_line), allowance, steps);
                for (Eigen::Index i = 0; i < edge.sew_line.rows(); ++i)
                    EXPECT_TRUE(contains(cut, Vec2(edge.sew_line.row(i))));
            }
            // Segments turn by 2 * 0.6 / 80 rad, so the mitres between them protrude by less than 1e-4 of the
            // allowance.
            const Points2 lower = edges[0].sew_line;
            double furthest = 0;
            for (Eigen::Index i = 20; i < 60; ++i)
                furthest = std::max(furthest, distance_to_outline(cut, lower.row(i)));
            EXPECT_LT(furthest, allowance * (1 + 1e-4) + steps);
        }
}

/// A piece 4 m wide whose lower outline turns by `turn` in its middle, with these allowances before and after, 20
/// mm elsewhere.
std::vector<AllowedEdge> bent(double turn, double before, double after, CornerRule rule_before, CornerRule rule_after) {
    const Vec2 far = 2 * Vec2(std::cos(turn), std::sin(turn));
    const Points2 corners = line({{-2, 0}, {0, 0}, {far.x(), far.y()}, {far.x() - 0.1, 6}, {-2, 6}, {-2, 0}});
    std::vector<AllowedEdge> edges;
    for (Eigen::Index e = 0; e + 1 < corners.rows(); ++e)
        edges.push_back({corners.middleRows(e, 2),
                         e == 0   ? before
                         : e == 1 ? after
                                  : 0.02,
                         e == 0   ? rule_before
                         : e == 1 ? rule_after
                                  : CornerRule::mitre});
    return edges;
}

/// The largest part of an allowance that is missing anywhere, perpendicular to its edge.
double missing(const std::vector<AllowedEdge>& edges, const Points2& cut) {
    double most = 0;
    for (const AllowedEdge& edge : edges) {
        if (edge.allowance == 0) continue;
        const Vec2 from = edge.sew_line.row(0), way = Vec2(edge.sew_line.row(1)) - from;
        const Vec2 outward = Vec2(way.y(), -way.x()).normalized();
        for (int i = 1; i < 400; ++i)
            for (const double share : {0.1, 0.5, 0.9, 1 - 1e-3})
                if (!contains(cut, Vec2(from + way * i / 400 + share * edge.allowance * outward)))
                    most = std::max(most, 1 - share);
    }
    return most;
}

TEST(CutLine, GivesEachOfTwoUnequalEdgesItsAllowanceUpToTheirCorner) {
    for (const double degrees : {0.5, 2.0, 5.0, 10.0, 30.0, 60.0, 90.0, 120.0})
        for (const auto& [before, after] : {std::pair(0.025, 0.010), std::pair(0.010, 0.025), std::pair(0.025, 0.0),
                                            std::pair(0.0, 0.038), std::pair(0.025, 0.025)})
            for (const CornerRule rule : {CornerRule::mitre, CornerRule::square}) {
                const auto edges = bent(degrees * std::numbers::pi / 180, before, after, rule, rule);
                const Points2 cut = cut_points(edges);
                EXPECT_EQ(missing(edges, cut), 0) << degrees << " degrees, " << before << " and " << after;
                EXPECT_EQ(self_intersections(cut).count, 0);
                EXPECT_GT(cut.col(1).minCoeff(), -3 * std::max(before, after) - 0.021) << "and no tongue";
            }
}

TEST(CutLine, FoldsAHemBesideFoldedSeamsAsBesideMitredOnes) {
    const double turn = 1.2;
    const Points2 mitred = cut_points(bent(turn, 0.038, 0.025, CornerRule::hem, CornerRule::mitre));
    const Points2 folded = cut_points(bent(turn, 0.038, 0.025, CornerRule::hem, CornerRule::fold));
    EXPECT_EQ(mitred, folded);
    const double unfolded = signed_area(cut_points(bent(turn, 0.038, 0.025, CornerRule::mitre, CornerRule::mitre)));
    EXPECT_GT(std::abs(signed_area(folded) - unfolded), 1e-5);
    const double slanted = signed_area(cut_points(bent(0.9, 0.02, 0.02, CornerRule::fold, CornerRule::fold)));
    const double straight = signed_area(cut_points(bent(0.9, 0.02, 0.02, CornerRule::mitre, CornerRule::mitre)));
    EXPECT_GT(std::abs(slanted - straight), 1e-5);
}

TEST(CutLine, FoldsNothingThatWouldRunFarFromItsCorner) {
    for (const double degrees : {2.0, 8.0, 15.0, 25.0, 35.0})
        for (const bool hem_first : {true, false}) {
            const auto edges =
                bent(degrees * std::numbers::pi / 180, hem_first ? 0.038 : 0.025, hem_first ? 0.025 : 0.038,
                     hem_first ? CornerRule::hem : CornerRule::mitre, hem_first ? CornerRule::mitre : CornerRule::hem);
            const Points2 cut = cut_points(edges);
            for (Eigen::Index i = 0; i < cut.rows(); ++i)
                EXPECT_TRUE(std::abs(cut(i, 0)) > 1 || cut(i, 1) > 1 || Vec2(cut.row(i)).norm() < 2.5 * 0.038 + steps)
                    << degrees << " degrees";
        }
}

TEST(CutLine, IsCutDownTheMiddleOfANarrowNotchOfTheSewLine) {
    const Points2 corners = line({{0, 0}, {1, 0}, {1, 1}, {0.52, 1}, {0.5, 0.5}, {0.48, 1}, {0, 1}, {0, 0}});
    std::vector<AllowedEdge> edges;
    for (Eigen::Index e = 0; e + 1 < corners.rows(); ++e) edges.push_back({corners.middleRows(e, 2), 0.03});
    const CutLine cut = make_cut_line(edges);
    EXPECT_EQ(self_intersections(cut.points).count, 0);
    for (const double y : {0.6, 0.7, 0.9, 0.99}) {
        EXPECT_FALSE(contains(cut.points, Vec2(0.5, y))) << y;
        for (const double side : {-1.0, 1.0}) {
            const double half = 0.02 * (y - 0.5) / 0.5;
            EXPECT_TRUE(contains(cut.points, Vec2(0.5 + side * half, y))) << y;
            EXPECT_NEAR(distance_along(cut.points, Vec2(0.5 + side * half, y), Vec2(-side, 0)), half, 0.6e-3) << y;
        }
    }
    EXPECT_TRUE(contains(cut.points, Vec2(0.5, 0.55))) << "the tip is the sewer's";
    ASSERT_EQ(cut.met.size(), 1U);
    EXPECT_EQ(cut.met[0].edge, 3);
    EXPECT_EQ(cut.met[0].mate_edge, 4);
}

TEST(CutLine, KeepsWhatAHookGoesRound) {
    // Its ends are closer than twice the allowance.
    const Points2 corners = line(
        {{0, 0}, {1, 0}, {1, 0.2}, {0.2, 0.2}, {0.2, 0.8}, {1, 0.8}, {1, 0.25}, {1.2, 0.25}, {1.2, 1}, {0, 1}, {0, 0}});
    std::vector<AllowedEdge> edges;
    for (Eigen::Index e = 0; e + 1 < corners.rows(); ++e) edges.push_back({corners.middleRows(e, 2), 0.04});
    const CutLine cut = make_cut_line(edges);
    EXPECT_EQ(self_intersections(cut.points).count, 0);
    for (Eigen::Index i = 0; i < corners.rows(); ++i) EXPECT_TRUE(contains(cut.points, Vec2(corners.row(i))));
    EXPECT_FALSE(contains(cut.points, Vec2(0.6, 0.5)));
    EXPECT_FALSE(cut.met.empty());
}

}  // namespace cut_line_test
}  // namespace ripstop
