#include "ripstop/pipeline/redesign/propose_redesign.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/measure/judge.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/model/plan/better_verdict.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/redesign/half_tile.h"
#include "ripstop/pipeline/redesign/weld_tiles.h"
#include "ripstop/report/words/proposals.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/seams.h"
#include "support/shapes.h"

namespace ripstop {
namespace propose_redesign_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double quarter_turn = std::numbers::pi / 2;

const Method& seam_exact() {
    return method_named("seam-exact");
}

CutPlan flat(const std::vector<Tile>& tiles, const Fabric& fabric = {}) {
    FlattenOptions options;
    options.fabric = fabric;
    options.tolerances = tolerances_of(fabric);
    return flatten_envelope({tiles}, options);
}

Tile gore(const std::string& name, double angle, int columns) {
    return make_tile(name, testing::lune(angle, columns, 24), {.warp = Vec3::UnitZ()});
}

TEST(ProposeSplit, HalvesTheQuarterSphereFromPoleToPoleAsPredicted) {
    const CutPlan plan = flat({gore("quarter", quarter_turn, 12)});
    const auto proposal = propose_split(plan.tiles[0], seam_exact(), plan.fabric, plan.tolerances);
    ASSERT_TRUE(proposal);
    EXPECT_EQ(proposal->direction, "along the warp");
    EXPECT_NEAR(std::abs(proposal->line.front().z()), 1, 1e-12);
    EXPECT_NEAR((proposal->line.front() + proposal->line.back()).norm(), 0, 1e-12) << "from pole to pole";
    // A gore of 360/n degrees with exact seams loses (1 - nu) beta^2 / 18 of its area: 13.7 % for n = 4, 3.43 %
    // for 8. The series is of second order in beta, so its error here is 10 %.
    const double before = plan.tiles[0].accuracy.area_error;
    EXPECT_NEAR(before, -quarter_turn * quarter_turn / 18, 0.015);
    for (const Trial& half : proposal->halves) {
        EXPECT_NEAR(half.accuracy.area_error, -quarter_turn * quarter_turn / 4 / 18, 0.0035);
        EXPECT_LE(half.verdict.findings.size(), plan.tiles[0].verdict.findings.size());
        EXPECT_LT(half.accuracy.energy, 0.1 * plan.tiles[0].accuracy.energy);
    }
    // The meridian passes through vertices, so each half has those of an eighth, with parallel diagonals.
    const CutPlan eighth = flat({gore("eighth", quarter_turn / 2, 6)});
    for (const Trial& half : proposal->halves) {
        EXPECT_EQ(half.triangles, eighth.tiles[0].tile.mesh.triangle_count());
        EXPECT_NEAR(half.accuracy.energy, eighth.tiles[0].accuracy.energy, 1e-3 * eighth.tiles[0].accuracy.energy);
    }
}

TEST(ProposeSplit, HasNothingToDrawOnWithoutASoundFlattening) {
    CutPlan plan = flat({gore("quarter", quarter_turn, 12)});
    plan.tiles[0].accuracy.flipped = 1;
    EXPECT_FALSE(propose_split(plan.tiles[0], seam_exact(), plan.fabric, plan.tolerances));
    plan.tiles[0].accuracy.flipped = 0;
    plan.tiles[0].flattening.positions = Points2();
    EXPECT_FALSE(propose_split(plan.tiles[0], seam_exact(), plan.fabric, plan.tolerances));
}

Verdict failing(const std::vector<Finding>& findings) {
    return {true, findings};
}

TEST(IsBetter, AsksForTheSameKindsOfFindingsAndLessOfEach) {
    const Verdict whole =
        failing({{"chain", "", {}, -0.4, 0.1}, {"chain", "", {}, 0.2, 0.1}, {"shear", "", {}, 12, 10}});
    EXPECT_TRUE(is_better(failing({}), whole));
    EXPECT_TRUE(is_better(
        failing({{"chain", "", {}, 0.3, 0.1}, {"chain", "", {}, 0.3, 0.1}, {"chain", "", {}, -0.3, 0.1}}), whole))
        << "more edges, each of them nearer";
    EXPECT_FALSE(is_better(failing({{"chain", "", {}, 0.41, 0.1}}), whole)) << "fewer findings, one of them worse";
    EXPECT_FALSE(is_better(whole, whole));
    EXPECT_FALSE(is_better(failing({{"area", "", {}, 1.1, 1}}), whole)) << "a new kind";
}

TEST(AddProposals, ProposesNothingWhereAHalfIsWorseAndNoneCanBeMade) {
    CutPlan plan = flat({gore("quarter", quarter_turn, 8)});
    plan.tiles[0].verdict.findings = {{"area", "", Vec3::Zero(), 1.5, 1}};
    EXPECT_FALSE(propose_split(plan.tiles[0], seam_exact(), plan.fabric, plan.tolerances))
        << "every half fails in strain too, which the whole is said not to";
}

/// The place of the line's middle between the corners of a gore: its distances from both meridians.
std::array<double, 2> from_meridians(const FlatTile& tile) {
    const std::vector<Vec3>& line = tile.proposal->line;
    const Vec3& middle = line[line.size() / 2];
    std::array<double, 2> nearest{10, 10};
    const std::vector<Chain>& chains = tile.tile.chains;
    for (std::size_t c = 0; c < 2; ++c)
        for (const int v : chains[c].vertices)
            nearest[c] = std::min(nearest[c], (Vec3(tile.tile.mesh.positions.row(v)) - middle).norm());
    return nearest;
}

TEST(AddProposals, GoToTilesThatAreCutAlikeWhereverTheyLie) {
    const Tile first = gore("first", quarter_turn, 8);
    TriangleMesh turned = first.mesh, mirrored = first.mesh;
    const Eigen::AngleAxisd turn(1.2, Vec3(1, 2, 3).normalized());
    for (Eigen::Index v = 0; v < turned.positions.rows(); ++v) {
        turned.positions.row(v) = turn * Vec3(turned.positions.row(v)) + Vec3(5, 0, 1);
        mirrored.positions.row(v) = Vec3(-mirrored.positions(v, 0), mirrored.positions(v, 1), mirrored.positions(v, 2));
    }
    mirrored.triangles.col(1).swap(mirrored.triangles.col(2));
    CutPlan plan = flat({first, make_tile("turned", turned, {.warp = turn * Vec3::UnitZ()}),
                         make_tile("mirrored", mirrored, {.warp = Vec3::UnitZ()})});
    ASSERT_TRUE(add_proposals(plan, seam_exact(), 0));
    ASSERT_TRUE(plan.tiles[0].proposal);
    const std::array<double, 2> there = from_meridians(plan.tiles[0]);
    for (std::size_t i = 1; i < 3; ++i) {
        ASSERT_TRUE(plan.tiles[i].proposal) << i;
        EXPECT_EQ(plan.tiles[i].proposal->direction, plan.tiles[0].proposal->direction);
        // a gore is its own mirror image, so the sides may be exchanged
        const std::array<double, 2> here = from_meridians(plan.tiles[i]);
        EXPECT_NEAR(std::min(here[0], here[1]), std::min(there[0], there[1]), 1e-6) << i;
        EXPECT_NEAR(std::max(here[0], here[1]), std::max(there[0], there[1]), 1e-6) << i;
    }
    EXPECT_THAT(proposals_text(plan), HasSubstr("first and 2 alike: of "));
}

TEST(AddProposals, IsForEachKindThatFailsWhereFewDo) {
    const Tile good = make_tile("good", testing::cylinder(1, 0.5, 1, 6, 6));
    Tile other = gore("sixth", std::numbers::pi / 3, 8);
    const std::vector<Tile> tiles{gore("first", quarter_turn, 8), good, gore("second", quarter_turn, 8), other};
    CutPlan plan = flat(tiles);
    EXPECT_FALSE(add_proposals(plan, seam_exact(), 0, {.kinds = 1}));
    EXPECT_FALSE(add_proposals(plan, seam_exact(), 0, {.triangles = 500}));
    for (const FlatTile& tile : plan.tiles) EXPECT_FALSE(tile.proposal) << "two kinds fail, which was too many";
    EXPECT_THAT(proposals_text(plan), IsEmpty());
    EXPECT_TRUE(add_proposals(plan, seam_exact(), 0));
    EXPECT_TRUE(plan.tiles[0].proposal);
    EXPECT_FALSE(plan.tiles[1].proposal) << "it can be made";
    ASSERT_TRUE(plan.tiles[2].proposal) << "equal to the first";
    EXPECT_EQ(plan.tiles[2].proposal->line, plan.tiles[0].proposal->line) << "and in the same place";
    EXPECT_TRUE(plan.tiles[3].proposal);
    const std::string text = proposals_text(plan);
    EXPECT_THAT(text, HasSubstr("first and 1 alike: of "));
    EXPECT_THAT(text, HasSubstr("along the warp from (0, 0, "));
    EXPECT_THAT(text, Not(HasSubstr("second")));
}

TEST(HalfTile, KeepsWarpCornersCurveLengthsAndCompensation) {
    const TriangleMesh sheet = testing::rectangle(2, 1, 8, 4);
    Tile whole =
        make_tile("sheet", sheet,
                  {.warp = Vec3(1, 0.1, 0), .compensation = {.warp = 0.01, .chains = {0.001, 0.002, 0.003, 0.004}}});
    whole.curve_lengths = 1.001 * edge_lengths(sheet.positions, closed(whole.boundary));
    const auto split = split_mesh(sheet, sheet.positions.col(0).array() - 0.7);
    ASSERT_TRUE(split);
    const Tile left = make_half_tile(whole, split->left, "left"), right = make_half_tile(whole, split->right, "right");
    for (const Tile* half : {&left, &right}) {
        EXPECT_EQ(half->chains.size(), 4u);
        EXPECT_NEAR((half->grain.direction - whole.grain.direction).norm(), 0, 1e-15);
        EXPECT_EQ(half->compensation.warp, 0.01);
        ASSERT_EQ(half->compensation.chains.size(), 4u);
    }
    // drawn edges stay drawn, and the cut has the same length on both sides
    EXPECT_NEAR(drawn_lengths(left).sum() + drawn_lengths(right).sum(), drawn_lengths(whole).sum() + 2, 1e-12);
    const auto extra_at = [](const Tile& half, const Vec3& middle) {
        for (std::size_t c = 0; c < half.chains.size(); ++c) {
            const std::vector<int>& v = half.chains[c].vertices;
            const Vec3 here = (half.mesh.positions.row(v.front()) + half.mesh.positions.row(v.back())) / 2;
            if ((here - middle).norm() < 1e-9) return half.compensation.chains[c];
        }
        return -1.0;
    };
    EXPECT_EQ(extra_at(left, {0.7, 0.5, 0}), 0) << "the cut";
    EXPECT_EQ(extra_at(right, {0.7, 0.5, 0}), 0);
    const auto whole_extra = [&](const Vec3& middle) { return extra_at(whole, middle); };
    EXPECT_EQ(extra_at(left, {1.35, 0, 0}), whole_extra({1, 0, 0}));
    EXPECT_EQ(extra_at(right, {0.35, 1, 0}), whole_extra({1, 1, 0}));
    EXPECT_EQ(extra_at(left, {2, 0.5, 0}), whole_extra({2, 0.5, 0}));
}

/// Two adjacent gores, sewn along the meridian between them.
Envelope two_gores(double angle, int columns) {
    TriangleMesh second = testing::lune(angle, columns, 24);
    const double c = std::cos(angle), s = std::sin(angle);
    for (Eigen::Index v = 0; v < second.positions.rows(); ++v) {
        const Vec3 p = second.positions.row(v);
        second.positions.row(v) << c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z();
    }
    Envelope envelope{{gore("west", angle, columns), make_tile("east", second, {.warp = Vec3::UnitZ()})}};
    // After rotation, its vertices match the first one's up to rounding only, so the seam is made by hand.
    const auto meridian = [&](int t, double longitude) {
        const Tile& tile = envelope.tiles[static_cast<std::size_t>(t)];
        for (std::size_t chain = 0; chain < tile.chains.size(); ++chain) {
            const int v = tile.chains[chain].vertices[5];
            if (std::abs(std::atan2(tile.mesh.positions(v, 1), tile.mesh.positions(v, 0)) - longitude) < 1e-9)
                return testing::run_of_chain(envelope, t, static_cast<int>(chain), 0, 24);
        }
        return SeamSide{};
    };
    Seam seam{"S1", meridian(0, angle / 2), meridian(1, angle / 2)};
    seam.length = testing::length(seam.a);
    envelope.seams = {seam};
    return envelope;
}

CutPlan sewn_gores(double angle, int columns, const Fabric& fabric) {
    FlattenOptions options;
    options.fabric = fabric;
    options.tolerances = tolerances_of(fabric);
    return flatten_envelope(two_gores(angle, columns), options);
}

TEST(ProposeMerges, FindsNarrowGoresThatCouldBeOne) {
    Fabric fabric;
    fabric.roll_width = 1;
    CutPlan plan = sewn_gores(0.1, 2, fabric);
    ASSERT_TRUE(plan.walks[0].ok);
    plan.merges = propose_merges(plan, seam_exact(), 0);
    ASSERT_EQ(plan.merges.size(), 1u);
    const MergeProposal& merge = plan.merges[0];
    EXPECT_EQ(merge.tile_a, 0);
    EXPECT_EQ(merge.tile_b, 1);
    // which is the gore of twice the angle
    const CutPlan one = flat({gore("one", 0.2, 4)}, fabric);
    EXPECT_EQ(merge.merged.triangles, one.tiles[0].tile.mesh.triangle_count());
    EXPECT_NEAR(merge.merged.accuracy.area, one.tiles[0].accuracy.area, 1e-9);
    EXPECT_NEAR(merge.merged.accuracy.area_error, one.tiles[0].accuracy.area_error, 1e-6);
    EXPECT_THAT(proposals_text(plan), HasSubstr("west and east could be one tile: area -0.2"));
}

TEST(ProposeMerges, LeavesWhatWouldNotLieOnTheRollOrFail) {
    Fabric narrow;
    narrow.roll_width = 0.15;
    EXPECT_THAT(propose_merges(sewn_gores(0.1, 2, narrow), seam_exact(), 0), IsEmpty());
    EXPECT_THAT(propose_merges(sewn_gores(0.5, 6, Fabric{}), seam_exact(), 0), IsEmpty());
}

TEST(WeldTiles, WeldsOnlyWhatHasTheSameVerticesAndWarp) {
    const Envelope envelope = two_gores(0.1, 2);
    const Seam& seam = envelope.seams[0];
    const Tile &a = envelope.tiles[0], &b = envelope.tiles[1];
    const auto welded = weld_tiles(a, b, seam);
    ASSERT_TRUE(welded);
    EXPECT_EQ(welded->mesh.vertex_count(), a.mesh.vertex_count() + b.mesh.vertex_count() - 25);
    EXPECT_NEAR(surface_area(welded->mesh), surface_area(a.mesh) + surface_area(b.mesh), 1e-12);
    Seam part = seam;
    part.b.parts.pop_back();
    EXPECT_FALSE(weld_tiles(a, b, part)) << "a T-junction";
    Tile turned = b;
    turned.grain.direction = Vec3::UnitY();
    EXPECT_FALSE(weld_tiles(a, turned, seam));
    Tile compensated = b;
    compensated.compensation.warp = 0.01;
    EXPECT_FALSE(weld_tiles(a, compensated, seam));
    Tile away = b;
    away.mesh.positions.col(0).array() += 0.001;
    EXPECT_FALSE(weld_tiles(a, away, seam));
    Tile measured = a;
    measured.curve_lengths = 1.002 * edge_lengths(a.mesh.positions, closed(a.boundary));
    Seam longer = seam;
    for (SeamPart& p : longer.a.parts) p.length *= 1.002;
    const auto kept = weld_tiles(measured, b, longer);
    ASSERT_TRUE(kept);
    EXPECT_NEAR(drawn_lengths(*kept).sum(),
                drawn_lengths(*welded).sum() + 0.002 * (drawn_lengths(a).sum() - seam.length), 1e-12);
}

}  // namespace propose_redesign_test
}  // namespace ripstop
