/// A floor with a round outline and a wall around it: both must take their common line as a polygon, or both as a
/// curve.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/assembly/faults/check_envelope.h"
#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/seam_doubts.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/tile/make_tile.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace ripstop {
namespace round_pool_test {

constexpr double radius = 2, height = 0.8;  // [m]

Vec3 on_rim(int i, int sides, double z) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const auto as_in_a_file = [](double x) { return std::round(x * 1e5) / 1e5; };
    return {as_in_a_file(radius * std::cos(angle)), as_in_a_file(radius * std::sin(angle)), z};
}

TriangleMesh floor_of(int sides) {
    TriangleMesh mesh;
    mesh.positions = Points3::Zero(sides + 1, 3);
    mesh.triangles.resize(sides, 3);
    for (int i = 0; i < sides; ++i) {
        mesh.positions.row(i) = on_rim(i, sides, 0).transpose();
        mesh.triangles.row(i) << sides, (i + 1) % sides, i;
    }
    return mesh;
}

/// Cut open at its start; seen from outside.
TriangleMesh wall_of(int sides) {
    return testing::grid(sides, 2, [=](double u, double v) {
        return on_rim(static_cast<int>(std::lround(u * sides)), sides, v * height);
    });
}

Envelope pool(int sides, bool floor_first) {
    std::vector<Tile> tiles{make_tile("FLOOR", floor_of(sides), {.warp = Vec3::UnitX()}),
                            make_tile("WALL", wall_of(sides), {.warp = Vec3::UnitZ()})};
    if (!floor_first) std::swap(tiles[0], tiles[1]);
    Envelope envelope{std::move(tiles)};
    add_seams(envelope);
    return envelope;
}

/// The widths of the cut wall at the bottom and at the top [m].
std::pair<double, double> widths(const CutPlan& plan) {
    const FlatTile& wall = plan.tiles[plan.tiles[0].tile.name == "WALL" ? 0 : 1];
    const FlatTile& bottom = plan.tiles[plan.tiles[0].tile.name == "WALL" ? 1 : 0];
    double below = 0, above = 0;
    for (const ChainAccuracy& chain : bottom.accuracy.chains) below += chain.flat_length;
    for (const ChainAccuracy& chain : wall.accuracy.chains) above = std::max(above, chain.flat_length);
    return {below, above};
}

template <class Findings>
bool has(const Findings& findings, const std::string& code) {
    return std::any_of(findings.begin(), findings.end(), [&](const auto& finding) { return finding.code == code; });
}

struct Outcome {
    CutPlan plan;
    EnvelopeCheck check;
};

Outcome outcome(const Envelope& given, const RemeshOptions& remesh) {
    Outcome result;
    result.check = check_envelope(given);
    add_seam_doubts(result.check, given, remesh);
    Envelope envelope = given;
    remesh_envelope(envelope, remesh);
    result.plan = flatten_envelope(envelope, {});
    return result;
}

/// The uncertainty of the length of the curve through a regular polygon's corners, as a share (`find_seams`): the
/// unknown part of the curve, and, if it stays a polygon, what the polygon lacks. A polygon with corners has none.
double open_share(int sides, bool is_round) {
    if (sides < 12) return 0;
    const double turn = 2 * std::numbers::pi / sides, short_by = turn * turn / 24;
    return short_by * turn * turn / 2 + (is_round ? 0 : short_by);
}

TEST(RoundPool, IsCutAsWideAboveAsBelowWhateverItsSides) {
    RIPSTOP_TOO_LONG_SANITIZED();
    for (const int sides : {6, 10, 11, 12, 13, 14, 16, 24, 32, 48})
        for (const RemeshMode mode : {RemeshMode::automatic, RemeshMode::never})
            for (const bool floor_first : {true, false}) {
                if (mode == RemeshMode::automatic && !can_remesh()) continue;
                const Outcome made = outcome(pool(sides, floor_first), {.mode = mode});
                const auto [below, above] = widths(made.plan);
                const std::string what = std::to_string(sides) + (mode == RemeshMode::never ? " never" : " auto") +
                                         (floor_first ? " floor first" : " wall first");
                EXPECT_NEAR(below, above, 1e-5 * above)
                    << what;  // the file's rounding turns the ends of the upper edge
                const double circle = 2 * std::numbers::pi * radius;
                const double polygon = 2 * radius * sides * std::sin(std::numbers::pi / sides);
                const bool is_round = sides >= 12 && mode == RemeshMode::automatic && std::abs(above - circle) < 2e-3;
                EXPECT_TRUE(is_round || std::abs(above - polygon) < 1e-3) << what << " " << above;
                const bool doubted = open_share(sides, is_round) > 0.001;  // round: below 14 sides; otherwise up to 40
                EXPECT_EQ(has(made.plan.findings, "uncertain"), doubted) << what;
                EXPECT_EQ(has(made.check.issues, "uncertain"), doubted) << what;
                EXPECT_EQ(made.plan.manufacturable(), !doubted) << what;
            }
}

TEST(RoundPool, IsRoundWhereItIsMeshedAnew) {
    if (!can_remesh()) GTEST_SKIP() << "built without CGAL";
    for (const int sides : {12, 16, 24}) {
        const Outcome made = outcome(pool(sides, true), {.mode = RemeshMode::automatic});
        EXPECT_NEAR(widths(made.plan).second, 2 * std::numbers::pi * radius, 2e-3) << sides;
    }
}

}  // namespace round_pool_test
}  // namespace ripstop
