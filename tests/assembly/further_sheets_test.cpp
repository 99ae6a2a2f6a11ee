/// Where three or more sheets meet on an edge, the skin keeps its seam and the others are sewn into it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "ripstop/assembly/faults/check_envelope.h"
#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/assembly/seams/one_sided.h"
#include "ripstop/tile/seam_sheets.h"
#include "ripstop/tile/targets.h"
#include "support/envelopes.h"
#include "support/further_sheets.h"
#include "support/shapes.h"

namespace ripstop {
namespace further_sheets_test {

using std::numbers::pi;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Meshes = std::vector<NamedMesh>;

/// Each seam as the names of its sheets: the two of the skin in alphabetical order, "+", the others in
/// alphabetical order.
std::multiset<std::string> names_of(const std::vector<Tile>& tiles, const std::vector<Seam>& seams) {
    std::multiset<std::string> names;
    for (const std::vector<SeamSheet>& sheets : sheets_of_seams(seams)) {
        if (sheets.empty()) continue;
        std::vector<std::string> all;
        for (const SeamSheet& sheet : sheets) all.push_back(tiles[static_cast<std::size_t>(sheet.side->tile)].name);
        std::sort(all.begin(), all.begin() + 2);
        std::sort(all.begin() + 2, all.end());
        std::string text = all[0] + " " + all[1];
        for (std::size_t k = 2; k < all.size(); ++k) text += " + " + all[k];
        names.insert(text);
    }
    return names;
}

std::multiset<std::string> seams_of(const Meshes& meshes, const std::vector<std::string>& inside = {}) {
    std::vector<Tile> tiles = testing::tiles_of(meshes).tiles;
    for (Tile& tile : tiles) tile.inside = std::find(inside.begin(), inside.end(), tile.name) != inside.end();
    return names_of(tiles, find_seams(tiles).seams);
}

/// Expects the same seams for every order of the tiles, whichever side of the `further` sheets is up.
void expect_seams(const Meshes& meshes, const std::multiset<std::string>& expected, const std::string& further,
                  int orders = 4) {
    EXPECT_EQ(seams_of(meshes), expected);
    std::mt19937 random(7);
    for (int k = 0; k < orders; ++k) {
        Meshes changed = meshes;
        for (std::size_t i = changed.size() - 1; i > 0; --i) std::swap(changed[i], changed[random() % (i + 1)]);
        for (NamedMesh& mesh : changed)
            if (mesh.name.starts_with(further) && random() % 2 == 0) mesh = testing::turned_over(mesh);
        EXPECT_EQ(seams_of(changed), expected) << k;
        const EnvelopeCheck check = check_envelope(testing::tiles_of(changed));
        for (const EnvelopeIssue& issue : check.issues) {
            EXPECT_NE(issue.code, "turned_over") << issue.message;
            EXPECT_NE(issue.code, "inside_out") << issue.message;
        }
        EXPECT_THAT(check.meant, ::testing::IsEmpty());
    }
}

double length(const SeamSide& side) {
    return std::accumulate(side.parts.begin(), side.parts.end(), 0.0,
                           [](double sum, const SeamPart& part) { return sum + part.length; });
}

/// Expects all sheets of a seam to have its length, and each tile's edges to be as long as its parts state.
void expect_one_length(const Meshes& meshes) {
    const Envelope envelope = testing::tiles_of(meshes);
    const FoundSeams found = find_seams(envelope.tiles);
    for (const Seam& seam : found.seams) {
        EXPECT_NEAR(length(seam.a), seam.length, 1e-9 * seam.length) << seam.id;
        EXPECT_NEAR(length(seam.b), seam.length, 1e-9 * seam.length) << seam.id;
    }
    for (const std::vector<SeamSheet>& sheets : sheets_of_seams(found.seams))
        for (const SeamSheet& sheet : sheets)
            for (const SeamPart& part : sheet.side->parts) {
                const Tile& tile = envelope.tiles[static_cast<std::size_t>(sheet.side->tile)];
                const Eigen::VectorXd& curved = found.curve_lengths[static_cast<std::size_t>(sheet.side->tile)];
                const double whole = curved.size() > 0 ? curved[part.edge] : drawn_lengths(tile)[part.edge];
                EXPECT_LE(part.length, whole * (1 + 1e-9)) << tile.name;
            }
}

std::string by_alphabet(const std::string& one, const std::string& other) {
    return std::min(one, other) + " " + std::max(one, other);
}

TEST(RibUnderASeam, IsSewnIntoItWhicheverComesFirstAndWhicheverSideIsUp) {
    for (const double slope : {0.0, 0.2, -0.3})
        for (const double lean : {0.0, 0.5, -0.5, 0.7, -0.7})
            expect_seams(testing::rib_under_seam(slope, lean), {"LEFT RIGHT + RIB"}, "RIB", 6);
}

TEST(RibUnderASeam, IsSewnIntoItHoweverTheThreeAreMeshed) {
    for (const std::vector<int>& edges : {std::vector{4, 7, 5}, {9, 4, 4}, {4, 4, 11}, {1, 1, 1}, {1, 5, 3}}) {
        expect_seams(testing::rib_under_seam(0.2, 0.1, edges), {"LEFT RIGHT + RIB"}, "RIB", 2);
        expect_one_length(testing::rib_under_seam(0.2, 0.1, edges));
    }
}

TEST(RibUnderASeam, IsSaidToBeSewnIntoItInOneSentence) {
    const EnvelopeCheck check = check_envelope(testing::tiles_of(testing::rib_under_seam(0.2)));
    EXPECT_THAT(check.issues, IsEmpty());
    EXPECT_THAT(check.notes,
                Contains("three tiles meet on this edge: LEFT and RIGHT are sewn, RIB is sewn into their seam"));
    EXPECT_EQ(check.seams, 2);
    EXPECT_EQ(check.sewn_in, 1);
    EXPECT_DOUBLE_EQ(check.seam_length, 1);
}

TEST(RibUnderASeam, IsTheSkinWhereTheProjectNamesAnotherAsDiaphragm) {
    Meshes meshes = testing::rib_under_seam(0.2);
    meshes[2] = testing::turned_over(meshes[2]);  // so that its direction is opposite to RIGHT's
    EXPECT_EQ(seams_of(meshes, {"LEFT"}), (std::multiset<std::string>{"RIB RIGHT + LEFT"}));
}

TEST(RibUnderASeam, LeavesATileThatIsTurnedOverToBeNamed) {
    Meshes meshes = testing::rib_under_seam(0.2);
    meshes[1] = testing::turned_over(meshes[1]);
    for (const bool rib_turned : {false, true}) {
        if (rib_turned) meshes[2] = testing::turned_over(meshes[2]);
        const EnvelopeCheck check = check_envelope(testing::tiles_of(meshes));
        ASSERT_EQ(check.issues.size(), 1u);
        EXPECT_EQ(check.issues[0].code, "turned_over");
        EXPECT_THAT(check.issues[0].message, ::testing::Not(HasSubstr("RIB")));
    }
}

/// WAIST lies along the x axis from 0 to 0.4 m; PANEL, 0.8 m wide, is below it. From 0.1 to 0.3 m the upper edge
/// of PANEL has three layers, which separate further down.
Meshes pleat_under_waist() {
    const auto folded = [](double u, double v) {
        const double x = u < 0.3 ? u : u < 0.5 ? 0.6 - u : u - 0.4;
        return Vec3(x, 0.3 * (v - 1), 0.5 * (1 - v) * std::clamp(u - 0.3, 0.0, 0.2));
    };
    return {{"WAIST", testing::grid(4, 2, [](double u, double v) { return Vec3(0.4 * u, 0.1 * v, 0); }), {}},
            {"PANEL", testing::grid(8, 3, [&](double u, double v) { return folded(0.8 * u, v); }), {}}};
}

TEST(Pleat, HasAllItsLayersSewn) {
    for (const bool panel_first : {false, true}) {
        Meshes meshes = pleat_under_waist();
        if (panel_first) std::swap(meshes[0], meshes[1]);
        const std::vector<Tile> tiles = testing::tiles_of(meshes).tiles;
        std::map<std::string, double> sewn;
        for (const Seam& seam : find_seams(tiles).seams) {
            EXPECT_FALSE(seam.into) << seam.id;
            for (const SeamSide* side : {&seam.a, &seam.b})
                sewn[tiles[static_cast<std::size_t>(side->tile)].name] += length(*side);
        }
        EXPECT_NEAR(sewn["WAIST"], 0.4, 1e-9);
        EXPECT_NEAR(sewn["PANEL"], 0.8, 1e-9);
    }
}

TEST(RibUnderAJunction, IsSewnIntoBothSeamsThatItLiesOn) {
    const Meshes whole = testing::rib_under_junction(0, 2), part = testing::rib_under_junction(0.3, 1.7);
    for (const Meshes& meshes : {whole, part}) {
        expect_seams(meshes, {"LEFT R1 + RIB", "LEFT R2 + RIB", "R1 R2"}, "RIB");
        expect_one_length(meshes);
    }
    expect_seams(testing::rib_under_junction(0.2, 0.9), {"LEFT R1 + RIB", "LEFT R2", "R1 R2"}, "RIB");
}

TEST(RibPastASeam, IsTheMateOfWhatGoesOnWithoutOne) {
    const Meshes meshes = testing::rib_past_seam();
    expect_seams(meshes, {"LEFT RIGHT + RIB", "LEFT RIB"}, "none");
    expect_one_length(meshes);
    const Envelope envelope = testing::tiles_of(meshes);
    const FoundSeams found = find_seams(envelope.tiles);
    double along = 0;
    for (const Seam& seam : found.seams)
        if (!seam.into) along += seam.length;
    EXPECT_NEAR(along, 2, 1e-9) << "nothing of LEFT's edge is left, nothing is sewn twice";
}

TEST(BallWithADisc, KeepsAllSeamsOfItsSkin) {
    for (const int disc_columns : {5, 4, 7}) {
        const Meshes meshes = testing::ball_with_disc(8, 5, disc_columns);
        std::multiset<std::string> expected;
        for (int k = 0; k < 8; ++k) {
            const std::string number = std::to_string(k);
            expected.insert("DOWN" + number + " UP" + number + " + DISC");
            for (const std::string row : {"UP", "DOWN"})
                expected.insert(by_alphabet(row + number, row + std::to_string((k + 1) % 8)));
        }
        expect_seams(meshes, expected, "DISC", 2);
        EXPECT_EQ(seams_of(meshes, {"DISC"}), expected);
        expect_one_length(meshes);
    }
}

TEST(OneSidedness, TellsSkinFromWhatHasTheSameOnBothSides) {
    const auto sided = [](const Meshes& meshes, const std::string& name) {
        const std::vector<Tile> tiles = testing::tiles_of(meshes).tiles;
        std::vector<char> wanted;
        for (const Tile& tile : tiles) wanted.push_back(tile.name == name);
        const std::vector<double> all = one_sidedness(tiles, wanted);
        return std::accumulate(all.begin(), all.end(), 0.0);
    };
    const Meshes ball = testing::ball_with_disc(4, 4, 4), hull = testing::hull_with_fin(false);
    EXPECT_EQ(sided(ball, "UP1"), 1) << "closed";
    EXPECT_EQ(sided(ball, "DISC"), 0) << "inside";
    EXPECT_GT(sided(hull, "PORT"), 0.7) << "open at its ends";
    EXPECT_LT(sided(hull, "FIN"), 0.2) << "outside";
}

TEST(HullWithAFin, KeepsItsSeamWhetherTheFinIsOfOneSheetOrTwo) {
    expect_seams(testing::hull_with_fin(false), {"PORT STARBOARD + FIN", "PORT STARBOARD"}, "FIN");
    Meshes meshes = testing::hull_with_fin(true);
    for (const bool is_turned : {false, true}) {
        for (NamedMesh& mesh : meshes)
            if (is_turned && mesh.name.starts_with("FIN")) mesh = testing::turned_over(mesh);
        expect_seams(meshes, {"PORT STARBOARD + FIN-P + FIN-S", "PORT STARBOARD", "FIN-P FIN-S"}, "none", 2);
        expect_one_length(meshes);
    }
}

/// The seams of a wing: across each rib, along each cell, and around the ribs at its tips.
std::multiset<std::string> seams_of_wing(int cells) {
    std::multiset<std::string> seams;
    for (int c = 1; c <= cells; ++c) {
        const std::string here = std::to_string(c), next = std::to_string(c + 1);
        for (const std::string skin : {"U", "L", "N", "T"}) {
            if (c < cells) seams.insert(by_alphabet(skin + here, skin + next) + " + R" + here);
            if (c == 1) seams.insert(by_alphabet(skin + here, "R0"));
            if (c == cells) seams.insert(by_alphabet(skin + here, "R" + here));
        }
        for (const std::string end : {"N", "T"})
            for (const std::string skin : {"U", "L"}) seams.insert(by_alphabet(end + here, skin + here));
    }
    return seams;
}

TEST(WingWithRibs, HasEverySeamOfItsSkinHoweverItIsMeshed) {
    for (const bool apart : {false, true}) {
        const Meshes meshes = testing::wing_with_ribs(12, 0.03, apart);
        std::vector<Tile> tiles = testing::tiles_of(meshes).tiles;
        expect_seams(meshes, seams_of_wing(12), "none", 2);
        expect_one_length(meshes);
        EXPECT_THAT(check_envelope({tiles}).issues, IsEmpty());
    }
}

TEST(WingWithRibs, HasEverySeamOfItsSkinWhicheverRibsAreTurnedOver) {
    for (const std::string& turned : std::vector<std::string>{"R1 R4", "R1 R2 R3 R4", "R3"}) {
        Meshes meshes = testing::wing_with_ribs(5, 0.02, false);
        for (NamedMesh& mesh : meshes)
            if (turned.find(mesh.name) != std::string::npos) mesh = testing::turned_over(mesh);
        EXPECT_EQ(seams_of(meshes), seams_of_wing(5));
        EXPECT_THAT(check_envelope(testing::tiles_of(meshes)).issues, IsEmpty());
    }
}

TEST(WingWithRibs, HasEverySeamOfItsSkinWhereItsLobesAreSoDeepThatARibGoesOnStraighter) {
    // The arch rises from the rib at 60 degrees: two panels meet at 60, a panel and a rib at 150.
    EXPECT_EQ(seams_of(testing::wing_with_ribs(4, 0.3 * std::tan(pi / 3) / pi, false)), seams_of_wing(4));
}

TEST(TwoSkinsAndARib, AreOneSeamOfFive) {
    expect_seams(testing::two_skins_and_rib(), {"TOP-L TOP-R + BELOW-L + BELOW-R + RIB"}, "RIB");
    expect_one_length(testing::two_skins_and_rib());
}

}  // namespace further_sheets_test
}  // namespace ripstop
