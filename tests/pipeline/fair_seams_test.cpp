#include "ripstop/pipeline/remesh/fair_seams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/model/tile/zigzag.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/tile/find_zigzags.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"
#include "support/zigzags.h"

namespace ripstop {
namespace fair_seams_test {

using namespace testing;
using ::testing::HasSubstr;

constexpr double tolerance = 0.5 * millimetre;

Envelope envelope_of(const std::vector<TriangleMesh>& meshes) {
    Envelope envelope;
    for (const TriangleMesh& mesh : meshes)
        envelope.tiles.push_back(make_tile(std::string("T").append(std::to_string(envelope.tiles.size() + 1)), mesh,
                                           {.warp = Vec3(0.6, 0.8, 0)}));
    add_seams(envelope, {tolerance});
    return envelope;
}

// A smooth cut that keeps the length of its edge loses K / (4 pi) of its area: 1.59 % at 0.2, 2.39 % at 0.3. The
// fair curve's distance from the circle, and polygons of 60 edges for circles, change that by a quarter of a per
// cent.
TEST(FairSeams, LetADiscBeJudgedAsItsSmoothCutIs) {
    for (const double curvature : {0.2, 0.3})
        for (const unsigned seed : {1u, 2u}) {
            Envelope envelope = envelope_of({zigzag_disc(curvature, 9, 0.2, seed)});
            const double area = surface_area(envelope.tiles[0].mesh);
            const std::vector<std::string> remarks = fair_seams(envelope, tolerance);
            ASSERT_EQ(remarks.size(), 1u);
            EXPECT_THAT(remarks[0], HasSubstr("cut along a fair curve"));
            EXPECT_TRUE(find_zigzags(envelope.tiles, envelope.seams).empty());
            EXPECT_EQ(envelope.tiles[0].chains.size(), 1u);
            EXPECT_NEAR(surface_area(envelope.tiles[0].mesh), area, 0.01 * area);
            const CutPlan plan = flatten_envelope(envelope, {});
            EXPECT_NEAR(plan.tiles[0].accuracy.area_error, -curvature / (4 * std::numbers::pi), 0.0025);
            EXPECT_FALSE(plan.manufacturable());
        }
}

TEST(FairSeams, AreTheSameOnBothSides) {
    Envelope envelope = envelope_of(cut_along_mesh(
        {0.1, 1, 0.2, 4}, [](const Vec2& p) { return p.norm() > 1 ? -1
                                                     : p.y() > 0  ? 0
                                                                  : 1; },
        [](const Vec2& p) { return onto_sphere(p); }));
    const std::size_t before = envelope.seams.size();
    const std::vector<std::string> remarks = fair_seams(envelope, tolerance);
    EXPECT_EQ(remarks.size(), 2u);
    EXPECT_LT(envelope.seams.size(), before);
    ASSERT_EQ(envelope.seams.size(), 1u);
    EXPECT_LT(envelope.seams[0].gap, 1e-12);
    EXPECT_NEAR(envelope.seams[0].length, 2, 0.2);  // it ends at vertices, up to an edge off the circle
    const CutPlan plan = flatten_envelope(envelope, {});
    EXPECT_TRUE(plan.walks[0].ok);
    for (const FlatTile& tile : plan.tiles)
        for (const Finding& finding : tile.verdict.findings) EXPECT_NE(finding.code, "zigzag");
}

TEST(FairSeams, LeaveAloneWhatDoesNotZigzag) {
    Envelope envelope = envelope_of({cap(0.5, 8)});
    const Points3 before = envelope.tiles[0].mesh.positions;
    EXPECT_THAT(fair_seams(envelope, tolerance), ::testing::ElementsAre(HasSubstr("no edge zigzags")));
    EXPECT_EQ(envelope.tiles[0].mesh.positions, before);
}

TEST(FairSeams, AreNotMadeWhereEachTriangleHasItsWarp) {
    Envelope envelope = envelope_of({zigzag_disc(0.2, 8, 0.2, 3)});
    Tile& tile = envelope.tiles[0];
    tile.grain.field = Points3::Zero(tile.mesh.triangle_count(), 3);
    tile.grain.field.col(0).setOnes();
    const Points3 before = tile.mesh.positions;
    EXPECT_THAT(fair_seams(envelope, tolerance), ::testing::ElementsAre(HasSubstr("warp of its own")));
    EXPECT_EQ(envelope.tiles[0].mesh.positions, before);
}

}  // namespace fair_seams_test
}  // namespace ripstop
