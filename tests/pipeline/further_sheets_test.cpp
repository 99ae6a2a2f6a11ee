/// A seam of three sheets through the whole program: one length on the cloth, notches and names on all sheets, one
/// line in flight.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include "ripstop/assembly/faults/check_envelope.h"
#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/flatten/seam/seam_stretch.h"
#include "ripstop/inflate/inflate.h"
#include "ripstop/io/json/sewing_json.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/tile/allowance.h"
#include "ripstop/tile/seam_sheets.h"
#include "ripstop/tile/targets.h"
#include "support/further_sheets.h"
#include "support/seams.h"

namespace ripstop {
namespace further_sheets_test {

using ::testing::Each;
using ::testing::IsSupersetOf;
using ::testing::UnorderedElementsAre;

constexpr int sectors = 4;

CutPlan plan_of(const std::vector<NamedMesh>& meshes) {
    FlattenOptions options;
    options.method = "seam-exact";
    return flatten_envelope(make_envelope(meshes, {}), options);
}

/// The cut ball, with its disk divided like the skin, or, if `apart`, differently.
const CutPlan& ball(bool apart) {
    static const CutPlan conforming = plan_of(testing::ball_with_disc(sectors, 4, 4));
    static const CutPlan other = plan_of(testing::ball_with_disc(sectors, 4, 6));
    return apart ? other : conforming;
}

const PatternPiece& named(const std::vector<PatternPiece>& pieces, const std::string& name) {
    return *std::find_if(pieces.begin(), pieces.end(), [&](const PatternPiece& piece) { return piece.name == name; });
}

/// The length on the cloth of the part of a sheet between `from` and `to` of the seam's drawn curve.
double cloth(const CutPlan& plan, const SeamSheet& sheet) {
    const FlatTile& flat = plan.tiles[static_cast<std::size_t>(sheet.side->tile)];
    const Eigen::VectorXd drawn = drawn_lengths(flat.tile);
    const Eigen::VectorXd cut = edge_lengths(flat.flattening.positions, closed(flat.tile.boundary));
    double sum = 0;
    for (const SeamPart& part : parts_between(sheet, sheet.from, sheet.to))
        sum += cut[part.edge] * part.length / drawn[part.edge];
    return sum;
}

TEST(SeamOfThree, HasOneLengthOnTheClothOfAllThree) {
    for (const bool apart : {false, true}) {
        const CutPlan& plan = ball(apart);
        int of_three = 0;
        for (const std::vector<SeamSheet>& sheets : sheets_of_seams(plan.seams)) {
            of_three += sheets.size() == 3;
            for (const SeamSheet& sheet : sheets) {
                EXPECT_NEAR(sheet.to - sheet.from, sheets[0].to, 1e-9);
                EXPECT_NEAR(cloth(plan, sheet), cloth(plan, sheets[0]), 1e-9 * sheets[0].to) << sheet.record->id;
            }
        }
        EXPECT_EQ(of_three, sectors);
        for (const SeamWalk& walk : plan.walks) EXPECT_TRUE(walk.ok);
    }
}

TEST(SeamOfThree, LeavesNoEdgeOfTheSkinToBeHemmed) {
    for (const bool apart : {false, true})
        for (const Eigen::VectorXd& left : free_lengths(ball(apart))) EXPECT_EQ(left.sum(), 0);
}

TEST(SeamOfThree, IsJudgedAlikeByCheckAndByFlatten) {
    for (const std::vector<int>& edges : {std::vector{4, 4, 4}, {4, 7, 5}}) {
        const std::vector<NamedMesh> meshes = testing::rib_under_seam(0.2, 0.1, edges);
        EXPECT_TRUE(check_envelope(make_envelope(meshes, {})).sound());
        const CutPlan plan = plan_of(meshes);
        EXPECT_TRUE(plan.findings.empty());
        for (const FlatTile& tile : plan.tiles) EXPECT_TRUE(tile.verdict.manufacturable()) << tile.tile.name;
    }
}

TEST(SeamOfThree, HasItsNotchesAtTheSamePlacesOnAllThree) {
    for (const bool apart : {false, true}) {
        const CutPlan& plan = ball(apart);
        const std::vector<PatternPiece> pieces = make_pieces(plan);
        for (const std::vector<SeamSheet>& sheets : sheets_of_seams(plan.seams)) {
            if (sheets.size() < 3) continue;
            std::map<int, std::set<std::pair<double, int>>> marks;  // for each tile: places and numbers of strokes
            for (const SeamSheet& sheet : sheets)
                for (const PieceNotch& notch : pieces[static_cast<std::size_t>(sheet.side->tile)].notches)
                    if (notch.seam == plan.seams[0].id || notch.seam == sheets[0].record->id)
                        if (notch.seam == sheets[0].record->id && notch.along > 1e-3 &&
                            notch.along < sheets[0].to - 1e-3)
                            marks[sheet.side->tile].insert({notch.along, notch.count});
            ASSERT_EQ(marks.size(), 3u);
            EXPECT_GE(marks.begin()->second.size(), 2u);
            for (const auto& [tile, places] : marks) EXPECT_EQ(places, marks.begin()->second);
        }
    }
}

TEST(SeamOfThree, IsNamedOnEachPieceWithBothOthers) {
    const std::vector<PatternPiece> pieces = make_pieces(ball(false));
    const auto mates_on_ring = [&](const std::string& name) {
        std::set<std::string> mates;
        for (const PieceEdge& edge : named(pieces, name).edges)
            for (const Mate& mate : edge.mates)
                if (edge.mates.size() > 1) mates.insert(mate.piece);
        return mates;
    };
    EXPECT_THAT(mates_on_ring("UP0"), UnorderedElementsAre("DISC", "DOWN0"));
    EXPECT_THAT(mates_on_ring("DOWN0"), UnorderedElementsAre("DISC", "UP0"));
    EXPECT_THAT(mates_on_ring("DISC"), IsSupersetOf({"UP0", "DOWN0", "UP3", "DOWN3"}));
    std::set<std::string> written;
    for (const Label& label : named(pieces, "UP0").labels) written.insert(label.text);
    EXPECT_THAT(written, IsSupersetOf({"DISC", "DOWN0"}));
}

double volume_of_skin(const CutPlan& plan) {
    double volume = 0;
    for (const FlatTile& flat : plan.tiles)
        for (int t = 0; flat.tile.name != "DISC" && t < flat.tile.mesh.triangle_count(); ++t)
            volume +=
                flat.tile.mesh.corner(t, 0).dot(flat.tile.mesh.corner(t, 1).cross(flat.tile.mesh.corner(t, 2))) / 6;
    return volume;
}

TEST(SeamOfThree, IsOneLineInFlightAndItsDiscHasGasOnBothSides) {
    for (const bool apart : {false, true})
        for (const bool is_named : {false, true}) {
            CutPlan plan = ball(apart);
            for (FlatTile& tile : plan.tiles) {
                tile.tile.fabric = Fabric{};
                tile.tile.fabric->mass = 1e-3;
            }
            InflateOptions options;
            if (is_named) options.sewing.rigging.diaphragms = {"DISC"};
            options.load.extra_pressure = 50;
            const Inflated inflated = inflate(plan, options);
            ASSERT_EQ(inflated.summary.termination, Termination::converged);
            EXPECT_NEAR(inflated.drawn_volume, volume_of_skin(plan), 1e-9);
            const std::size_t disc = plan.tiles.size() - 1;
            // In the second case a vertex of the disk hangs on an edge of the skin, off its vertices by up to a
            // sagitta.
            for (const int v : plan.tiles[disc].tile.boundary) {
                double nearest = 1;
                for (std::size_t t = 0; t < disc; ++t)
                    for (const int w : plan.tiles[t].tile.boundary)
                        nearest = std::min(
                            nearest,
                            (inflated.tiles[disc].positions.row(v) - inflated.tiles[t].positions.row(w)).norm());
                EXPECT_LT(nearest, apart ? 0.25 : 1e-9);
            }
        }
}

TEST(SeamOfThree, IsReadBackFromThePlan) {
    const CutPlan& plan = ball(true);
    std::istringstream text(sewing_json(plan, std::vector<std::string>(plan.tiles.size(), "a")));
    const Sewing sewing = read_sewing(text, "sewing.json");
    ASSERT_EQ(sewing.plan.seams.size(), plan.seams.size());
    for (std::size_t s = 0; s < plan.seams.size(); ++s) {
        const auto &there = sewing.plan.seams[s].into, &here = plan.seams[s].into;
        ASSERT_EQ(there.has_value(), here.has_value());
        if (!here) continue;
        EXPECT_EQ(there->seam, here->seam);
        EXPECT_EQ(there->from, here->from);
        EXPECT_EQ(there->backwards, here->backwards);
    }
}

TEST(SeamOfThree, StaysOneWhereTilesAreRemeshed) {
    if (!can_remesh()) GTEST_SKIP() << "built without CGAL";
    for (const bool whole : {true, false}) {
        Envelope envelope = make_envelope(
            whole ? testing::rib_under_seam(0.2, 0, {4, 7, 5}) : testing::rib_under_junction(0.3, 1.7), {});
        const std::size_t seams = envelope.seams.size();
        remesh_envelope(envelope, {.mode = RemeshMode::by_length, .edge_length = 0.11});
        for (const Tile& tile : envelope.tiles) EXPECT_TRUE(tile.remeshed) << tile.name;
        ASSERT_EQ(envelope.seams.size(), seams);
        for (const Seam& seam : envelope.seams) {
            EXPECT_NEAR(testing::length(seam.a), seam.length, 1e-9);
            EXPECT_NEAR(testing::length(seam.b), seam.length, 1e-9);
        }
        EXPECT_EQ(find_seams(envelope.tiles).seams.size(), seams);
    }
}

TEST(SeamOfThree, TakesTheTypeOfTheSeamItLiesInAndCountsOnce) {
    const Envelope envelope = make_envelope(testing::rib_under_seam(0.2), {});
    for (const SeamTypeUse& use : seam_types_used(envelope))
        if (use.type == envelope.seams[0].type) {
            EXPECT_EQ(use.seams, 1);
        }
    EXPECT_EQ(envelope.seams[1].type, envelope.seams[0].type);
}

}  // namespace further_sheets_test
}  // namespace ripstop
