#include "ripstop/model/tile/zigzag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/tile/find_zigzags.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"
#include "support/zigzags.h"

namespace ripstop {
namespace zigzag_test {

using namespace testing;

std::vector<Zigzag> zigzags_of(const TriangleMesh& mesh) {
    const Tile tile = make_tile("tile", mesh);
    return find_zigzags(std::vector<Tile>{tile}, {});
}

TEST(Zigzags, GoRoundADiscThatIsCutAlongItsMesh) {
    for (const double jumble : {0.0, 0.25})
        for (const unsigned seed : {1u, 2u, 3u}) {
            const TriangleMesh disc = zigzag_disc(0.2, 10, jumble, seed);
            const std::vector<Zigzag> found = zigzags_of(disc);
            ASSERT_EQ(found.size(), 1u) << jumble << " " << seed;
            EXPECT_TRUE(found[0].closed);
            const double edge = 10 * std::sqrt(0.2 / std::numbers::pi) / 10;
            EXPECT_GT(found[0].teeth, 0.4 * edge);
            EXPECT_LT(found[0].teeth, 1.6 * edge);
            EXPECT_GT(found[0].length, 1.1 * found[0].fair_length);
            EXPECT_NEAR(found[0].fair_length, 15.73, 0.02 * 15.73);
        }
}

TEST(Zigzags, AreNoCornersNoCurvesAndNoScallopsManyEdgesWide) {
    for (const Shape& shape : developable_shapes()) EXPECT_TRUE(zigzags_of(shape.mesh).empty()) << shape.name;
    for (const Shape& shape : curved_shapes()) EXPECT_TRUE(zigzags_of(shape.mesh).empty()) << shape.name;
    EXPECT_TRUE(zigzags_of(cap(0.5, 3)).empty());
    EXPECT_TRUE(zigzags_of(cap(0.5, 12)).empty());
    const auto hem = [](int edges, int scallops) {
        return grid(edges * scallops, 4, [=](double u, double v) {
            const double drop = 0.1 * std::abs(std::sin(std::numbers::pi * scallops * u));
            return Vec3(2 * u, v - (1 - v) * drop, 0);
        });
    };
    EXPECT_TRUE(zigzags_of(hem(8, 8)).empty());
    EXPECT_TRUE(zigzags_of(hem(16, 5)).empty());
}

TEST(Zigzags, AreOneARunBetweenTheNeighboursAndNameTheirSeams) {
    // A disk whose lower half is a second tile: the cut between the two follows the mesh, as their outlines do.
    const std::vector<TriangleMesh> halves = cut_along_mesh(
        {0.1, 1, 0.2, 4}, [](const Vec2& p) { return p.norm() > 1 ? -1
                                                     : p.y() > 0  ? 0
                                                                  : 1; },
        [](const Vec2& p) { return onto_sphere(p); });
    Envelope envelope{{make_tile("upper", halves[0], {.warp = Vec3::UnitX()}),
                       make_tile("lower", halves[1], {.warp = Vec3::UnitX()})}};
    add_seams(envelope);
    int along_mate = 0, along_nothing = 0;
    for (const Zigzag& zigzag : find_zigzags(envelope.tiles, envelope.seams)) {
        EXPECT_FALSE(zigzag.closed);
        EXPECT_EQ(zigzag.seams.empty(), zigzag.mate.empty());
        if (zigzag.mate.empty())
            ++along_nothing;
        else
            ++along_mate;
        EXPECT_EQ(zigzag.mate.empty() ? "" : zigzag.tile == 0 ? "lower" : "upper", zigzag.mate);
    }
    EXPECT_EQ(along_mate, 2);  // one on each side
    EXPECT_EQ(along_nothing, 2);
}

}  // namespace zigzag_test
}  // namespace ripstop
