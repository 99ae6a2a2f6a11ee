/// `check` and `flatten` judge alike: `flatten` does not pass what `check` calls wrong, for any shape and mesh.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <numbers>
#include <random>

#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/envelope_faults.h"
#include "ripstop/pipeline/read/own_meshes.h"
#include "ripstop/pipeline/read/seam_doubts.h"
#include "ripstop/remesh/remesh_disk.h"
#include "support/envelopes.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace agreement_test {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

using Meshes = std::vector<NamedMesh>;

struct Outcome {
    EnvelopeCheck check;
    CutPlan plan;
};

/// Judges the input as the two commands do.
Outcome outcome(EnvelopeInput input, const RemeshOptions& remesh, const std::vector<std::string>& accept = {}) {
    Outcome result;
    JudgeOptions judging;
    judging.accept = accept;
    const EnvelopeCheck faults = judge_input(input, judging);
    result.check = faults;
    add_seam_doubts(result.check, input.drawn ? input.drawn->envelope : input.envelope, remesh);
    result.plan = flatten_envelope(input.envelope, {});
    if (remesh.mode == RemeshMode::automatic) prefer_own_meshes(result.plan, input, {});
    add_faults(result.plan, faults);
    return result;
}

Outcome outcome(const Meshes& meshes, RemeshMode mode, const std::vector<std::string>& accept = {}) {
    RemeshOptions remesh;
    remesh.mode = mode;
    EnvelopeInput input;
    input.envelope = make_envelope(meshes, {});
    if (mode != RemeshMode::never) input.drawn = AsDrawn{input.envelope, {}};
    remesh_envelope(input.envelope, remesh);
    return outcome(std::move(input), remesh, accept);
}

void expect_agreement(const Outcome& made, const std::string& what) {
    if (!made.check.sound()) {
        EXPECT_FALSE(made.plan.manufacturable()) << what << ": " << made.check.issues.front().message;
    }
}

const std::vector<std::string>& all_that_may_be_meant() {
    static const std::vector<std::string> codes(acceptable_issues.begin(), acceptable_issues.end());
    return codes;
}

Meshes balloon() {
    EnvelopeDesign design;
    design.gores = 6;
    design.panels = 3;
    design.volume = 400;
    design.edge_length = 0.9;
    return design_natural(design);
}

void move_mesh(TriangleMesh& mesh, const Vec3& by) {
    mesh.positions.rowwise() += by.transpose();
}

/// Damages a random tile as a CAD might, or adds such a fault on purpose.
void spoil(Meshes& tiles, std::mt19937& random) {
    const std::size_t t = random() % tiles.size();
    const double size = std::array{0.0002, 0.002, 0.05, 1.0, 40.0}[random() % 5];
    switch (random() % 7) {
        case 0:
            move_mesh(tiles[t].mesh, size * Vec3(0.6, -0.64, 0.48));
            break;
        case 1:
            tiles[t].mesh.triangles.col(0).swap(tiles[t].mesh.triangles.col(1));
            break;
        case 2:
            tiles.push_back({fmt::format("copy{}", tiles.size()), tiles[t].mesh, {}});
            break;
        case 3:
            if (tiles.size() > 2) tiles.erase(tiles.begin() + static_cast<std::ptrdiff_t>(t));
            break;
        case 4:
            tiles[t].mesh.positions *= 1 + size;
            break;
        case 5:
            tiles.push_back({fmt::format("vent{}", tiles.size()), testing::cap(0.2, 3), {}});
            move_mesh(tiles.back().mesh, Vec3(0, 0, 9 + size));
            break;
        default:
            for (std::size_t i = 0; i <= t; ++i) move_mesh(tiles[i].mesh, Vec3(0, 0, size));
    }
}

TEST(CheckAndFlatten, AgreeOnEnvelopesThatWereSpoiled) {
    RIPSTOP_TOO_LONG_SANITIZED();
    std::mt19937 random(17);
    for (int k = 0; k < 40; ++k) {
        Meshes tiles = k % 2 == 0 ? testing::square_tube() : balloon();
        spoil(tiles, random);
        if (k % 3 == 0) spoil(tiles, random);
        for (const RemeshMode mode : {RemeshMode::never, RemeshMode::automatic}) {
            if (mode == RemeshMode::automatic && (!can_remesh() || k % 4 > 1)) continue;
            const std::string what = std::to_string(k) + (mode == RemeshMode::never ? " never" : " auto");
            expect_agreement(outcome(tiles, mode), what);
            expect_agreement(outcome(tiles, mode, all_that_may_be_meant()), what + ", accepted");
        }
    }
}

TEST(CheckAndFlatten, AgreeOnPolygonsThatMayBeCurves) {
    for (const int sides : {8, 11, 12, 13, 16, 30})
        for (const RemeshMode mode : {RemeshMode::never, RemeshMode::automatic}) {
            if (mode == RemeshMode::automatic && !can_remesh()) continue;
            Meshes tiles{{"SLEEVE", testing::cylinder(1, 2 * std::numbers::pi, 2, sides, 2), {}}};
            expect_agreement(outcome(tiles, mode), std::to_string(sides) + " sides, one tile");
            const TriangleMesh half = testing::cylinder(1, std::numbers::pi, 2, sides, 2);
            TriangleMesh other = testing::cylinder(1, std::numbers::pi, 2, sides / 2, 2);
            other.positions.leftCols(2) *= -1;
            expect_agreement(outcome({{"A", half, {}}, {"B", other, {}}}, mode), std::to_string(sides) + " sides");
        }
}

TEST(CheckAndFlatten, AgreeOnTheSharedShapes) {
    RIPSTOP_REQUIRE_SHARED(folder, "faults/shapes");
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".obj") continue;
        for (const RemeshMode mode : {RemeshMode::never, RemeshMode::automatic}) {
            ReadOptions reading;
            reading.remesh.mode = can_remesh() ? mode : RemeshMode::never;
            expect_agreement(outcome(read_input(entry.path(), reading), reading.remesh),
                             entry.path().filename().string());
        }
    }
}

TEST(AMissingTile, IsAFindingUnlessItIsAccepted) {
    Meshes holed = testing::square_tube();
    EXPECT_TRUE(outcome(holed, RemeshMode::never).plan.manufacturable());
    holed.erase(holed.begin() + 4);
    const Outcome made = outcome(holed, RemeshMode::never);
    EXPECT_FALSE(made.check.sound());
    EXPECT_FALSE(made.plan.manufacturable());
    ASSERT_EQ(made.plan.findings.size(), 1u);
    EXPECT_EQ(made.plan.findings[0].code, "missing_tile");
    EXPECT_THAT(made.plan.findings[0].message, HasSubstr("; if the opening is intended, give --accept missing_tile"));
    EXPECT_EQ(made.plan.findings[0].tiles.size(), 4u);
    const Outcome accepted = outcome(holed, RemeshMode::never, {"missing_tile"});
    EXPECT_TRUE(accepted.check.sound());
    EXPECT_TRUE(accepted.plan.manufacturable());
    EXPECT_THAT(accepted.check.notes, Contains(HasSubstr(" of edge; that is accepted (missing_tile)")));
    EXPECT_THAT(accepted.plan.remarks, Contains(HasSubstr(" of edge; that is accepted (missing_tile)")));
}

TEST(AGap, CannotBeAccepted) {
    Meshes tiles = testing::square_tube();
    for (std::size_t t = 2; t < tiles.size(); t += 3) move_mesh(tiles[t].mesh, Vec3(0, 0, 0.002));
    const Outcome made = outcome(tiles, RemeshMode::never, {"gap", "missing_tile"});
    EXPECT_FALSE(made.check.sound());
    EXPECT_FALSE(made.plan.manufacturable());
}

TEST(PartsThatAreSewnToNothingElse, AreNotesOfBoth) {
    Meshes tiles = testing::square_tube();
    tiles.push_back({"POCKET", testing::rectangle(0.5, 0.2, 3, 3), {}});
    move_mesh(tiles.back().mesh, Vec3(9, 0, 1));
    const Outcome made = outcome(tiles, RemeshMode::never);
    EXPECT_TRUE(made.check.sound());
    EXPECT_TRUE(made.plan.manufacturable());
    EXPECT_THAT(made.check.notes, Contains(HasSubstr("tile POCKET at ")));
    EXPECT_THAT(made.plan.remarks, Contains(HasSubstr("tile POCKET at ")));
}

TEST(SomeTilesAlone, AreNotBlamedForThoseLeftOut) {
    EnvelopeInput input;
    Meshes some = testing::square_tube();
    some.erase(some.begin() + 4);
    some.push_back({"FAR", testing::rectangle(0.5, 0.2, 3, 3), {}});
    move_mesh(some.back().mesh, Vec3(9, 0, 1));
    input.envelope = make_envelope(some, {});
    EXPECT_FALSE(judge_input(input, {}).sound());
    EXPECT_THAT(judge_input(input, {}).notes, Contains(HasSubstr("FAR")));
    JudgeOptions part;
    part.is_whole = false;
    const EnvelopeCheck check = judge_input(input, part);
    EXPECT_TRUE(check.sound());
    EXPECT_THAT(check.meant, ::testing::IsEmpty());
    EXPECT_THAT(check.notes, Not(Contains(HasSubstr("FAR"))));
}

/// A sound plan of two tiles with one seam.
CutPlan two_sheets() {
    TriangleMesh beside = testing::rectangle(1, 1, 4, 4);
    move_mesh(beside, Vec3(1, 0, 0));
    return flatten_envelope(make_envelope({{"A", testing::rectangle(1, 1, 4, 4), {}}, {"B", beside, {}}}, {}), {});
}

TEST(WhatFails, IsCountedTilesBeforeSeamsAndSeamsThatAreUncertainToo) {
    CutPlan plan = two_sheets();
    ASSERT_EQ(plan.walks.size(), 1u);
    EXPECT_EQ(count_failing(plan), (Failing{0, 0}));
    plan.walks[0].uncertainty = 2 * plan.walks[0].limit;
    EXPECT_EQ(count_failing(plan), (Failing{0, 1}));
    plan.walks[0].ok = false;
    EXPECT_EQ(count_failing(plan), (Failing{0, 1})) << "one seam";
    plan.tiles[1].verdict.findings.push_back({"area", "", Vec3::Zero(), 2, 1});
    EXPECT_EQ(count_failing(plan), (Failing{1, 1}));
    EXPECT_LT((Failing{0, 9}), (Failing{1, 0}));
}

TEST(OwnMeshes, AreTakenWhereLessFailsOnThem) {
    EnvelopeInput input;
    TriangleMesh beside = testing::rectangle(1, 1, 4, 4);
    move_mesh(beside, Vec3(1, 0, 0));
    input.envelope = make_envelope({{"A", testing::rectangle(1, 1, 4, 4), {}}, {"B", beside, {}}}, {});
    input.remarks = {"2 tiles remeshed"};
    CutPlan plan = flatten_envelope(input.envelope, {});
    EXPECT_FALSE(prefer_own_meshes(plan, input, {})) << "there are no others";
    input.drawn = AsDrawn{input.envelope, {"as read"}};
    for (FlatTile& tile : plan.tiles) tile.tile.remeshed = Remeshed{};
    EXPECT_FALSE(prefer_own_meshes(plan, input, {})) << "nothing fails";
    plan.walks[0].uncertainty = 2 * plan.walks[0].limit;
    EXPECT_TRUE(prefer_own_meshes(plan, input, {}));
    EXPECT_FALSE(plan.tiles[0].tile.remeshed);
    EXPECT_FALSE(input.drawn);
    EXPECT_THAT(input.remarks,
                ::testing::ElementsAre("as read",
                                       "all tiles keep their drawn meshes, because fewer fail on them: 0 tiles "
                                       "and 0 seams instead of 0 tiles and 1 seam"));
}

}  // namespace agreement_test
}  // namespace ripstop
