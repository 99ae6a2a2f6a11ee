/// Every fault of an envelope is reported once, at the tile that causes it.
#include "ripstop/assembly/faults/check_envelope.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ripstop/report/words/check_report.h"
#include "ripstop/tile/make_tile.h"
#include "support/checked_balloon.h"
#include "support/envelopes.h"
#include "support/shapes.h"

namespace ripstop {
namespace check_envelope_test {

using ::testing::HasSubstr;
using namespace checked_balloon;

TEST(SoundEnvelope, IsSoundAndItsFiguresAreThoseOfTheDesign) {
    for (const std::vector<NamedMesh>& balloon : both_balloons()) {
        const EnvelopeCheck result = check(balloon);
        EXPECT_TRUE(result.sound()) << (result.sound() ? "" : result.issues[0].message);
        EXPECT_EQ(result.tiles, 72);
        EXPECT_EQ(result.chains, 4 * 72);
        EXPECT_EQ(result.corners, 4 * 72);
        EXPECT_EQ(result.seams, 72 + 60);
        EXPECT_EQ(result.parts, 1);
        EXPECT_EQ(result.loose_ends, 0);
        EXPECT_EQ(result.odd_corners, 0);
        EXPECT_EQ(result.t_junctions, 0);
        ASSERT_EQ(result.loops.size(), 2u) << "mouth and crown";
        for (const LooseLoop& loop : result.loops) {
            EXPECT_TRUE(loop.closed);
            EXPECT_EQ(loop.corners, 0);
            EXPECT_EQ(loop.tiles.size(), 12u);
            EXPECT_FALSE(loop.outline);
        }
        EXPECT_EQ(result.sampling.size(), 132u);
    }
}

TEST(DoubledTiles, AreNotSaidToHaveNoSeamsBesideTheSeamsAsGiven) {
    // the second strip lies on the first, turned over: all their edges are sewn together
    NamedMesh under = strip("under", 0, 2, 0.3);
    under.mesh.triangles.col(1).swap(under.mesh.triangles.col(2));
    const EnvelopeCheck result = check({strip("over", 0, 2, 0.3), under, strip("far", 10, 12, 0.1)});
    EXPECT_GT(result.seams, 0);
    EXPECT_THAT(named(result), ::testing::ElementsAre("doubled under"));
    ASSERT_THAT(meant(result), ::testing::ElementsAre("unsewn -"));
    EXPECT_THAT(result.meant[0].message, HasSubstr("after the faults are corrected"));
    EXPECT_THAT(result.meant[0].message, ::testing::Not(HasSubstr("there are no seams")));
}

TEST(MissingTile, IsNamedWithItsNeighbours) {
    for (std::vector<NamedMesh> balloon : both_balloons()) {
        const Vec3 place = middle_of(balloon[middle].mesh);
        const std::string above = balloon[middle + 1].name;
        balloon.erase(balloon.begin() + middle);
        const EnvelopeCheck result = check(balloon);
        ASSERT_EQ(result.issues.size(), 1u);
        const EnvelopeIssue& issue = result.issues[0];
        EXPECT_EQ(issue.code, "missing_tile");
        EXPECT_LT((issue.at - place).norm(), 0.3);
        EXPECT_EQ(issue.tiles.size(), 4u);
        EXPECT_THAT(issue.tiles, ::testing::Contains(above));
        EXPECT_THAT(issue.message, HasSubstr("a tile is missing at"));
        EXPECT_EQ(issue.message, issue.fact + "; add the tile; if the opening is intended, give --accept missing_tile");
    }
}

TEST(MissingTiles, AreNamedWhereverSeveralLieTogether) {
    const std::vector<std::vector<std::size_t>> missing = {{middle, middle + 1},
                                                           {middle, middle + 6},
                                                           {middle, middle + 7},
                                                           {middle, middle + 1, middle + 6},
                                                           {18, 19, 20, 21, 22, 23}};  // the last one is a gore
    for (const std::vector<NamedMesh>& balloon : both_balloons())
        for (const std::vector<std::size_t>& some : missing) {
            std::vector<NamedMesh> holed = balloon;
            for (std::size_t k = some.size(); k-- > 0;)
                holed.erase(holed.begin() + static_cast<std::ptrdiff_t>(some[k]));
            const EnvelopeCheck result = check(holed);
            EXPECT_FALSE(result.sound()) << some.size() << " " << some[1];
            for (const EnvelopeIssue& issue : result.issues) EXPECT_EQ(issue.code, "missing_tile") << issue.message;
        }
}

TEST(MissingTile, AtTheMouthIsSuspectedFromTheCornersOfTheOpenEdge) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    balloon.erase(balloon.begin() + 6);
    EXPECT_THAT(named(check(balloon)), ::testing::ElementsAre(HasSubstr("missing_tile")));
}

/// `panels` columns of `rows` flat tiles each. Their lower edges form a polygon of radius 1, the upper ones, 2 m
/// higher, a polygon of radius `top`.
std::vector<NamedMesh> prism(int panels, int rows, double top) {
    std::vector<NamedMesh> tiles;
    const auto at = [&](int panel, double height) {
        const double angle = 2 * std::numbers::pi * panel / panels, radius = 1 + (top - 1) * height;
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), 2 * height);
    };
    for (int p = 0; p < panels; ++p)
        for (int r = 0; r < rows; ++r)
            tiles.push_back({std::to_string(p) + "-" + std::to_string(r),
                             testing::grid(2, 2,
                                           [&](double u, double v) {
                                               const double height = (r + v) / rows;
                                               return Vec3((1 - u) * at(p, height) + u * at(p + 1, height));
                                           }),
                             {}});
    return tiles;
}

TEST(Rim, OfATubeWithSidesIsNoMissingTile) {
    for (const int panels : {3, 4, 5, 6, 8, 9})
        for (const int rows : {1, 3}) {
            EXPECT_THAT(named(check(prism(panels, rows, 1))), ::testing::IsEmpty()) << panels << " " << rows;
            EXPECT_THAT(named(check(prism(panels, rows, 0.8))), ::testing::IsEmpty()) << panels << " " << rows;
        }
    for (const int panels : {5, 6, 8}) EXPECT_THAT(named(check(prism(panels, 1, 0.1))), ::testing::IsEmpty()) << panels;
}

TEST(MissingTile, OfATubeWithSidesIsNamedThoughItsRimsAreNot) {
    for (const int panels : {4, 6, 8}) {
        std::vector<NamedMesh> tube = prism(panels, 3, 1);
        const Vec3 place = middle_of(tube[4].mesh);
        tube.erase(tube.begin() + 4);
        const EnvelopeCheck result = check(tube);
        ASSERT_THAT(named(result), ::testing::ElementsAre(HasSubstr("missing_tile"))) << panels;
        EXPECT_LT((result.issues[0].at - place).norm(), 0.3);
    }
}

TEST(FlippedTile, IsNamed) {
    for (std::vector<NamedMesh> balloon : both_balloons()) {
        balloon[middle].mesh.triangles.col(0).swap(balloon[middle].mesh.triangles.col(1));
        const EnvelopeCheck result = check(balloon);
        EXPECT_THAT(named(result), ::testing::ElementsAre("turned_over " + balloon[middle].name));
        EXPECT_THAT(result.issues[0].message, HasSubstr("is inside out"));
    }
}

TEST(FlippedTiles, AllOfThemAreAnEnvelopeInsideOut) {
    for (std::vector<NamedMesh> balloon : both_balloons()) {
        for (NamedMesh& tile : balloon) tile.mesh.triangles.col(0).swap(tile.mesh.triangles.col(1));
        const EnvelopeCheck result = check(balloon);
        EXPECT_THAT(named(result), ::testing::ElementsAre("inside_out -"));
    }
}

TEST(FlippedTiles, NextToEachOtherAreOneFault) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    for (const std::size_t t : {middle, middle + 1})
        balloon[t].mesh.triangles.col(0).swap(balloon[t].mesh.triangles.col(1));
    const EnvelopeCheck result = check(balloon);
    ASSERT_EQ(result.issues.size(), 1u);
    EXPECT_THAT(result.issues[0].tiles, ::testing::ElementsAre(balloon[middle].name, balloon[middle + 1].name));
}

TEST(DoubledTile, IsNamedEitherWayUp) {
    for (const std::vector<NamedMesh>& balloon : both_balloons())
        for (const bool flipped : {false, true}) {
            std::vector<NamedMesh> doubled = balloon;
            doubled.push_back(doubled[middle]);
            doubled.back().name = "copy";
            if (flipped) doubled.back().mesh.triangles.col(0).swap(doubled.back().mesh.triangles.col(1));
            const EnvelopeCheck result = check(doubled);
            EXPECT_THAT(named(result), ::testing::ElementsAre("doubled copy")) << flipped;
            if (!result.issues.empty()) {
                EXPECT_THAT(result.issues[0].message, HasSubstr("lies on tile " + balloon[middle].name));
            }
        }
}

TEST(DoubledTile, IsNamedAlsoWithAnotherMesh) {
    std::vector<NamedMesh> doubled = testing::meshed_apart(small_balloon(), 4, 2);
    doubled.push_back(testing::meshed_apart(small_balloon(), 11, 2)[middle]);
    doubled.back().name = "copy";
    EXPECT_THAT(named(check(doubled)), ::testing::ElementsAre("doubled copy"));
}

TEST(GapOfAMillimetre, InOneEdgeIsNamedWithBothTiles) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    TriangleMesh& mesh = balloon[middle].mesh;
    const Tile tile = make_tile("t", mesh);
    const auto top = std::max_element(tile.chains.begin(), tile.chains.end(), [&](const Chain& p, const Chain& q) {
        return mesh.positions(p.vertices[1], 2) < mesh.positions(q.vertices[1], 2);
    });
    for (const int v : top->vertices) mesh.positions(v, 2) -= 0.001;
    const EnvelopeCheck result = check(balloon);
    ASSERT_EQ(result.issues.size(), 1u);
    EXPECT_EQ(result.issues[0].code, "gap");
    EXPECT_THAT(result.issues[0].tiles,
                ::testing::UnorderedElementsAre(balloon[middle].name, balloon[middle + 1].name));
    EXPECT_NEAR(result.issues[0].value, 0.001, 1e-4);
    EXPECT_THAT(result.issues[0].message, HasSubstr("1.00 mm apart"));
}

TEST(OverlapOfAMillimetre, IsNotCalledAGap) {
    const NamedMesh a{"a", testing::rectangle(2, 2, 3, 3), {}};
    for (const double gap : {0.001, -0.001}) {
        NamedMesh b{"b", testing::rectangle(2, 2, 3, 4), {}};
        move(b.mesh, Vec3(2 + gap, 0, 0));
        const EnvelopeCheck result = check({a, b});
        ASSERT_FALSE(result.issues.empty());
        EXPECT_THAT(result.issues[0].message, HasSubstr(gap > 0 ? "close the gap" : "trim the overlap"));
    }
}

TEST(GapOfAMillimetre, AllRoundIsOneFault) {
    for (std::vector<NamedMesh> balloon : both_balloons()) {
        for (std::size_t t = 0; t < balloon.size(); ++t)
            if (t % 6 > 2) move(balloon[t].mesh, Vec3(0, 0, 0.001));
        const EnvelopeCheck result = check(balloon);
        ASSERT_EQ(result.issues.size(), 1u);
        EXPECT_EQ(result.issues[0].code, "gap");
        EXPECT_EQ(result.issues[0].tiles.size(), 24u);
        EXPECT_THAT(result.issues[0].message, HasSubstr("12 pairs of tiles"));
    }
}

TEST(GapOfAMillimetre, FromMouthToCrownIsNoMissingTile) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    const Vec3 apart = centroid(balloon[balloon.size() / 8].mesh).cwiseProduct(Vec3(1, 1, 0)).normalized();
    for (std::size_t t = 0; t < balloon.size() / 2; ++t) move(balloon[t].mesh, 0.001 * apart);
    const EnvelopeCheck result = check(balloon);
    ASSERT_FALSE(result.issues.empty());
    for (const EnvelopeIssue& issue : result.issues) EXPECT_NE(issue.code, "missing_tile") << issue.message;
}

TEST(TwoFaults, AreBothNamed) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    move(balloon[middle].mesh, Vec3(0.02, 0, 0.01));
    balloon[middle + 24].mesh.triangles.col(0).swap(balloon[middle + 24].mesh.triangles.col(1));
    balloon.erase(balloon.begin() + 51);
    EXPECT_THAT(named(check(balloon)),
                ::testing::ElementsAre("turned_over " + balloon[middle + 24].name, "shifted " + balloon[middle].name,
                                       HasSubstr("missing_tile")));
}

TEST(Unit, IsProposedWhereTheSizeIsNoBalloons) {
    for (const std::vector<NamedMesh>& balloon : both_balloons()) {
        std::vector<NamedMesh> scaled = balloon;
        for (NamedMesh& tile : scaled) tile.mesh.positions *= 1000;
        const EnvelopeCheck large = check(scaled);
        ASSERT_THAT(named(large), ::testing::ElementsAre("unit -"));
        EXPECT_THAT(large.issues[0].message, HasSubstr("with --unit mm it would measure"));
        EXPECT_TRUE(large.seams_sought);
        EXPECT_FALSE(large.loops.empty());
        for (NamedMesh& tile : scaled) tile.mesh.positions *= 1e-6;
        const EnvelopeCheck small = check_envelope(testing::tiles_of(scaled), {}, {{"mm", 0.001}});
        ASSERT_THAT(named(small), ::testing::ElementsAre("unit -"));
        EXPECT_THAT(small.issues[0].message, HasSubstr("with --unit m it would measure"));
        EXPECT_FALSE(small.seams_sought) << "edges of some mm mean nothing against a tolerance of 0.5 mm";
        const std::string text = check_text(small, "small.obj", "mm");
        EXPECT_THAT(text, HasSubstr("\nseams          not searched for"));
        EXPECT_THAT(text, HasSubstr("\nopen edges     not searched for\nloose ends     not searched for\n"));
        EXPECT_THAT(text, ::testing::Not(HasSubstr("closed")));
        EXPECT_THAT(text, ::testing::Not(HasSubstr(" part")));
        EXPECT_THAT(check_json(small, "small.obj", "mm"), HasSubstr("\"loops\": null"));
    }
}

TEST(Unit, InDoubtHidesNoSeams) {
    // as large as gores in mm that are read as inches
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    for (NamedMesh& tile : balloon) tile.mesh.positions *= 25.4;
    const EnvelopeCheck result = check_envelope(testing::tiles_of(balloon), {}, {{"in", 0.0254}});
    EXPECT_THAT(named(result), ::testing::ElementsAre("unit -"));
    EXPECT_EQ(result.seams, 72 + 60);
    EXPECT_EQ(result.parts, 1);
    EXPECT_EQ(result.loops.size(), 2u) << "mouth and crown";
    EXPECT_THAT(check_text(result, "gores.obj", "in"), ::testing::Not(HasSubstr("not searched for")));
}

TEST(LooseTiles, AreOneNoteWhereNothingIsSewnAndNoneWhereThereIsOneTile) {
    const NamedMesh tile{"a", testing::rectangle(2, 2, 3, 3), {}};
    EXPECT_THAT(meant(check({tile})), ::testing::IsEmpty());
    NamedMesh far = tile;
    far.name = "b";
    move(far.mesh, Vec3(7, 0, 0));
    EXPECT_THAT(meant(check({tile, far})), ::testing::ElementsAre("unsewn -"));
    EXPECT_TRUE(check({tile, far}).sound());
}

TEST(StrayTile, IsANoteForItMayBeMeant) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    balloon.push_back({"vent", testing::cap(0.3, 6), {}});
    move(balloon.back().mesh, Vec3(0, 0, 3));
    const EnvelopeCheck result = check(balloon);
    EXPECT_TRUE(result.sound());
    EXPECT_THAT(meant(result), ::testing::ElementsAre("apart vent"));
    EXPECT_THAT(result.notes, ::testing::Contains(HasSubstr("tile vent at (")));
    EXPECT_THAT(result.notes,
                ::testing::Contains(HasSubstr(" m is sewn to nothing; if that is not intended, move it")));
}

TEST(StrayTile, ThatCameAwayFromItsPlaceLeavesAHoleWhichIsAnIssue) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    move(balloon[middle].mesh, Vec3(60, 5, 40));
    balloon[middle].mesh = testing::shuffled(balloon[middle].mesh, 3);
    EXPECT_FALSE(check(balloon).sound());
}

TEST(StrayTiles, OfASecondEnvelopeAreOneNote) {
    std::vector<NamedMesh> both = design_natural(small_balloon());
    for (NamedMesh tile : design_natural(small_balloon())) {
        tile.name = "second " + tile.name;
        move(tile.mesh, Vec3(30, 0, 0));
        both.push_back(std::move(tile));
    }
    const EnvelopeCheck result = check(both);
    EXPECT_TRUE(result.sound());
    EXPECT_EQ(result.parts, 2);
    ASSERT_EQ(result.meant.size(), 1u);
    EXPECT_THAT(result.meant[0].message, HasSubstr("and 66 more) are sewn to one another but to nothing else"));
}

TEST(Tolerance, IsProposedWhereMostEdgesMiss) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    for (NamedMesh& tile : balloon) scale_about(tile.mesh, middle_of(tile.mesh), 0.999);
    const EnvelopeCheck result = check(balloon);
    ASSERT_EQ(result.issues.size(), 1u);
    EXPECT_THAT(result.issues[0].message, HasSubstr("give --seam-tolerance"));
}

TEST(OddCorner, IsCountedWhereOnlyOneSideHasIt) {
    // the left sheet has a corner in the middle of its edge, the right one has none
    Envelope envelope;
    TileOptions options;
    options.corners = {{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}};
    envelope.tiles.push_back(make_tile("left", testing::rectangle(1, 1, 4, 4), options));
    TriangleMesh right = testing::rectangle(1, 1, 3, 6);
    move(right, Vec3(1, 0, 0));
    envelope.tiles.push_back(make_tile("right", right));
    const EnvelopeCheck result = check_envelope(envelope);
    EXPECT_EQ(result.seams, 2);
    EXPECT_EQ(result.odd_corners, 1);
}

}  // namespace check_envelope_test
}  // namespace ripstop
