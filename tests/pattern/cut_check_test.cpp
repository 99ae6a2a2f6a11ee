#include "ripstop/pattern/cut/cut_check.h"

#include <gmock/gmock.h>

#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/pieces.h"
#include "support/flat_tiles.h"
#include "support/openings.h"

namespace ripstop {
namespace cut_check_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> faults_of(const PatternPiece& piece) {
    std::vector<std::string> messages;
    for (const CutFault& fault : check_cut_line(piece)) messages.push_back(fault.message);
    return messages;
}

/// Tests what must hold for any cut line, independently of the code that makes or checks it.
void expect_cut_round(const PatternPiece& piece, const std::string& what) {
    EXPECT_EQ(self_intersections(piece.cut_line).count, 0) << what;
    EXPECT_GT(signed_area(piece.cut_line), 0) << what;
    const Eigen::Index count = piece.sew_line.rows();
    for (Eigen::Index i = 0; i < count; ++i)
        for (const double share : {0.0, 0.3, 0.7}) {
            const Vec2 at = (1 - share) * piece.sew_line.row(i) + share * piece.sew_line.row((i + 1) % count);
            EXPECT_TRUE(testing::turns_round(piece.cut_line, at) == 1 ||
                        distance_to_outline(piece.cut_line, at) < 0.06e-3)
                << what << " at " << at.transpose();
        }
    EXPECT_THAT(faults_of(piece), IsEmpty()) << what;
}

/// What remains of an allowance in a gap, by the formula in the header.
double left_in(double gap, double allowance, double other) {
    const double room = std::max((gap - 5e-5) / 2, gap - 5e-5 - other);
    return room < allowance ? room - std::clamp(std::min(0.1 * room, allowance - room), 0.0, 5e-4) : allowance;
}

TEST(CutCheck, KeepsTheOpeningOfEveryKeyholeAndSaysWhereItsHemsMeet) {
    const double size = testing::keyhole_size, depth = testing::keyhole_depth;
    for (const double allowance : {0.005, 0.025, 0.038})
        for (const double side : {0.1, 0.3})
            for (const double share : {0.0, 0.004, 0.2, 0.6, 0.9, 0.999, 1.0, 1.001, 1.2, 1.3}) {
                const double slit = 2 * share * allowance;
                const std::string what = "a slit of " + std::to_string(slit) + " and " + std::to_string(allowance);
                const PatternPiece piece = testing::cut_piece(testing::square_keyhole(slit, side, allowance));
                expect_cut_round(piece, what);
                EXPECT_EQ(testing::turns_round(piece.cut_line, Vec2(size / 2, depth + side / 2)), 0) << what;
                const double whole = std::pow(size + 2 * allowance, 2) - std::pow(side - 2 * allowance, 2);
                const double length = depth + 2 * allowance;  // of the cut, from outside to inside
                if (share >= 1.001) {
                    EXPECT_THAT(piece.met, IsEmpty()) << what;
                    const double slot = slit - 2 * left_in(slit, allowance, allowance);
                    EXPECT_NEAR(signed_area(piece.cut_line), whole - slot * length, 1e-5) << what;
                    continue;
                }
                // The slot is at most 1.05 mm wide; at its ends the hems' corners are blunted by less than half of
                // them.
                EXPECT_LT(signed_area(piece.cut_line), whole - 4e-5 * depth) << what;
                EXPECT_GT(signed_area(piece.cut_line), whole - 1.06e-3 * length - 2 * allowance * allowance) << what;
                if (2 * allowance - slit < 2e-5) {
                    EXPECT_THAT(piece.met, IsEmpty()) << "they just fit";
                    continue;
                }
                ASSERT_EQ(piece.met.size(), 1U) << what;
                const MetAllowances& met = piece.met.front();
                EXPECT_NEAR(met.gap, slit, 1e-9) << what;
                EXPECT_NEAR(met.left, left_in(slit, allowance, allowance), 1e-6) << what;
                EXPECT_NEAR(met.length, depth, std::max(0.01, 2 * allowance)) << what;
                EXPECT_NEAR(std::abs(met.at.x() - size / 2), slit / 2, 1e-9) << what;
            }
}

TEST(CutCheck, KeepsRoundOpeningsOfAnySize) {
    for (const double radius : {0.02, 0.03, 0.1, 0.25})
        for (const double slit : {0.002, 0.01, 0.03, 0.035}) {
            const std::string what = "radius " + std::to_string(radius) + ", slit " + std::to_string(slit);
            const PatternPiece piece = testing::cut_piece(testing::round_keyhole(slit, radius, 0.025));
            expect_cut_round(piece, what);
            ASSERT_FALSE(piece.met.empty()) << what;
            if (radius > 0.026) {
                EXPECT_EQ(testing::turns_round(piece.cut_line, Vec2(0.4, 0.4)), 0) << what;
            }
        }
}

TEST(CutCheck, CutsRingsOpenAtAnyAngle) {
    const double allowance = 0.025;
    for (const double angle : {300.0, 345.0, 350.0, 351.0, 352.0, 356.0, 358.0, 359.0, 359.9, 359.99, 359.999, 360.0}) {
        const std::string what = std::to_string(angle) + " degrees";
        const PatternPiece piece = testing::cut_piece(testing::open_ring(angle * degree, allowance));
        expect_cut_round(piece, what);
        EXPECT_EQ(testing::turns_round(piece.cut_line, Vec2(0, 0)), 0) << what;
        EXPECT_EQ(testing::turns_round(piece.cut_line, Vec2(0.2, 0.1)), 0) << what;
        const double gap = 2 * 0.3 * std::sin((360 - angle) * degree / 2);
        EXPECT_EQ(piece.met.empty(), gap >= 2 * allowance) << what;
        if (piece.met.empty()) continue;
        EXPECT_NEAR(piece.met.front().gap, gap, 1.5e-3) << what;
        // Rims are chords of 5 degrees, so their mitres protrude by 1e-3 of the allowance.
        const double ring = angle * degree / 2 * (std::pow(1 + allowance, 2) - std::pow(0.3 - allowance, 2));
        EXPECT_NEAR(signed_area(piece.cut_line), ring, 0.02 * ring) << what << ": 3.30 m2 without its opening";
    }
}

TEST(CutCheck, LeavesCornersThatTurnInwardToTheSewer) {
    for (const double angle : {60.0, 75.0, 90.0, 120.0, 150.0, 179.0}) {
        const PatternPiece piece = testing::cut_piece(testing::notched_strip(angle * degree, 0.025));
        expect_cut_round(piece, std::to_string(angle));
        EXPECT_THAT(piece.met, IsEmpty()) << angle;
        EXPECT_NEAR(distance_to_outline(piece.cut_line, Vec2(0, 0.5)), 0.025 / std::sin(angle * degree / 2), 1e-6)
            << angle << ": where the two allowances meet";
    }
    for (const double angle : {1.0, 4.0, 10.0, 20.0, 40.0, 50.0}) {
        const PatternPiece piece = testing::cut_piece(testing::notched_strip(angle * degree, 0.025));
        expect_cut_round(piece, std::to_string(angle));
        ASSERT_EQ(piece.met.size(), 1U) << angle;
        EXPECT_EQ(testing::turns_round(piece.cut_line, Vec2(0, 0.99)), 0) << angle << ": cut down its middle";
        EXPECT_NEAR(distance_to_outline(piece.cut_line, Vec2(0, 0.5)), 2 * 0.025, 0.01)
            << angle << ": as far as twice the allowance from the tip";
    }
}

TEST(CutCheck, GivesTheWiderOfTwoAllowancesWhatTheNarrowerLeaves) {
    for (const double gap : {0.004, 0.02, 0.03, 0.04, 0.047}) {
        std::vector<AllowedEdge> edges = testing::square_keyhole(gap, 0.2, 0.038);
        edges[5].allowance = 0.010;  // the left side of the slit
        const PatternPiece piece = testing::cut_piece(edges);
        expect_cut_round(piece, std::to_string(gap));
        const double middle = testing::keyhole_size / 2, left = middle - gap / 2, right = middle + gap / 2;
        const Vec2 at_left(left, 0.1), at_right(right, 0.1);
        EXPECT_NEAR(distance_along(piece.cut_line, at_left, Vec2::UnitX()), left_in(gap, 0.010, 0.038), 1e-6) << gap;
        EXPECT_NEAR(distance_along(piece.cut_line, at_right, -Vec2::UnitX()), left_in(gap, 0.038, 0.010), 1e-6) << gap;
    }
}

TEST(CutCheck, FindsTheOpeningThatAUnionLost) {
    PatternPiece piece = testing::cut_piece(testing::square_keyhole(0.03, 0.3, 0.025));
    piece.met.clear();
    EXPECT_THAT(faults_of(piece), ::testing::Contains(HasSubstr("has an allowance of")))
        << "nothing says that less was taken";
    piece.cut_line.resize(4, 2);
    piece.cut_line << -0.025, -0.025, 0.825, -0.025, 0.825, 0.825, -0.025, 0.825;
    const std::vector<CutFault> faults = check_cut_line(piece);
    ASSERT_GE(faults.size(), 2U);
    for (const CutFault& fault : faults) EXPECT_THAT(fault.message, HasSubstr("is not cut over"));
    EXPECT_NEAR(faults[0].value, 250, 30) << "a side of the slit [mm]";
}

TEST(CutCheck, FindsClothThatIsMissing) {
    PatternPiece piece = testing::cut_piece(testing::square_keyhole(0.08, 0.3, 0.025));
    EXPECT_THAT(faults_of(piece), IsEmpty());
    PatternPiece narrow = piece;
    narrow.cut_line.col(0) = narrow.cut_line.col(0).cwiseMin(0.81);
    EXPECT_THAT(faults_of(narrow),
                ::testing::ElementsAre(HasSubstr("edge 2 (hem) has an allowance of 10 mm instead of 25")));
    narrow.cut_line.col(0) = narrow.cut_line.col(0).cwiseMin(0.79);
    EXPECT_THAT(faults_of(narrow), ::testing::Contains(HasSubstr("the sew line leaves the cut line by 10.0 mm")));
    PatternPiece turned = piece;
    turned.cut_line = piece.cut_line.colwise().reverse().eval();
    EXPECT_THAT(faults_of(turned), ::testing::Contains(HasSubstr("clockwise")));
    PatternPiece crossed = piece;
    crossed.cut_line.row(3).swap(crossed.cut_line.row(4));
    EXPECT_THAT(faults_of(crossed), ::testing::Contains(HasSubstr("meets itself")));
}

/// A square with a slot 30 mm wide and 300 mm deep; all edges are hems.
FlatTile slotted_tile() {
    Points2 corners(8, 2);
    corners << 0, 0, 0.8, 0, 0.8, 0.8, 0.415, 0.8, 0.415, 0.5, 0.385, 0.5, 0.385, 0.8, 0, 0.8;
    return testing::flat_polygon("slotted", corners);
}

TEST(CutCheck, JudgesTheTileWithPlaceAndWidths) {
    CutPlan plan;
    plan.tiles = {slotted_tile()};
    const std::vector<PatternPiece> pieces = make_pieces(plan);
    EXPECT_THAT(judge_cut_lines(plan, pieces, false), IsEmpty());
    ASSERT_EQ(plan.tiles[0].verdict.findings.size(), 1U);
    const Finding& finding = plan.tiles[0].verdict.findings[0];
    EXPECT_EQ(finding.code, "allowances_meet");
    EXPECT_THAT(finding.message, HasSubstr("25 + 25 mm in a gap of 30 mm"));
    EXPECT_THAT(finding.message, HasSubstr("--allowance-fit"));
    EXPECT_NEAR(finding.value, 30, 1e-6);
    EXPECT_NEAR(finding.limit, 50, 1e-6);
    EXPECT_NEAR(std::abs(finding.at.x() - 0.4), 0.015, 1e-9);
    EXPECT_GT(finding.at.y(), 0.5 - 1e-9);
    EXPECT_FALSE(plan.manufacturable());
}

TEST(CutCheck, TakesWhatFitsWhereThatIsAskedForAndSaysSo) {
    CutPlan plan;
    plan.tiles = {slotted_tile()};
    const std::vector<std::string> notes = judge_cut_lines(plan, make_pieces(plan), true);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0], HasSubstr("slotted: the allowances of"));
    EXPECT_THAT(notes[0], HasSubstr("leaves 14.5 mm"));
    EXPECT_TRUE(plan.manufacturable());
}

TEST(CutCheck, LeavesAFindingWhereNothingIsLeftToSew) {
    CutPlan plan;
    plan.tiles = {slotted_tile()};
    std::vector<PatternPiece> pieces = make_pieces(plan);
    pieces[0].met[0].left = 0.0004;
    EXPECT_THAT(judge_cut_lines(plan, pieces, true), IsEmpty());
    ASSERT_EQ(plan.tiles[0].verdict.findings.size(), 1U);
    EXPECT_THAT(plan.tiles[0].verdict.findings[0].message, HasSubstr("nothing to sew"));
}

}  // namespace cut_check_test
}  // namespace ripstop
