#include "ripstop/pipeline/flatten/equal_pieces.h"

#include <gtest/gtest.h>

#include "ripstop/design/natural/gores.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/measure/measure_bounds.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/report/figures/figures.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace equal_pieces_test {

/// Copies of an asymmetric patch: rotated, renumbered, mirrored, and with another warp.
std::vector<Tile> four_alike() {
    const TriangleMesh patch = testing::grid(8, 10, [](double u, double v) {
        const double x = u * (1 + 0.3 * v), y = 1.5 * v;
        return Vec3(x, y, 0.2 * x * x - 0.1 * x * y);
    });
    const Vec3 warp = Vec3(1, 0.3, 0.1).normalized();
    TriangleMesh turned = patch;
    const Eigen::AngleAxisd turn(2.1, Vec3(1, 2, -0.5).normalized());
    turned.positions = patch.positions * turn.toRotationMatrix().transpose();
    const TriangleMesh left = testing::mirrored(patch);
    return {make_tile("first", patch, {.warp = warp}),
            make_tile("turned", testing::shuffled(turned, 3), {.warp = turn * warp}),
            make_tile("reversed", turned, {.warp = -(turn * warp)}),
            make_tile("left", testing::shuffled(left, 4), {.warp = Vec3(-warp.x(), warp.y(), warp.z())})};
}

TEST(EqualPieces, TakeWhatFlatteningEachAloneWouldGive) {
    const Fabric fabric = fabric_named("nylon");
    const std::vector<Tile> tiles = four_alike();
    const std::vector<Likeness> likeness = find_equal_tiles(tiles);
    for (const char* name : {"seam-exact", "seam-exact-area", "lscm", "arap"}) {
        const auto flatten = method_named(name).flatten;
        FlatTile first;
        first.tile = tiles[0];
        first.flattening = flatten(tiles[0], fabric);
        for (std::size_t i = 1; i < tiles.size(); ++i) {
            SCOPED_TRACE(tiles[i].name + " " + name);
            ASSERT_EQ(likeness[i].to, 0);
            ASSERT_FALSE(likeness[i].vertex.empty());
            const Flattening copy = copied_flattening(first, tiles[i], likeness[i]), alone = flatten(tiles[i], fabric);
            EXPECT_LT((copy.positions - alone.positions).rowwise().norm().maxCoeff(), 1e-9);
            ASSERT_EQ(copy.seam_tension.size(), alone.seam_tension.size());
            if (copy.seam_tension.size() == 0) continue;
            EXPECT_LT((copy.seam_tension - alone.seam_tension).lpNorm<Eigen::Infinity>(),
                      1e-6 * alone.seam_tension.lpNorm<Eigen::Infinity>());
        }
    }
}

TEST(EqualPieces, AreListedWithTheirQuantities) {
    FlattenOptions options;
    options.fabric = fabric_named("nylon");
    const CutPlan plan = flatten_envelope({four_alike()}, options);
    EXPECT_EQ(plan.tiles[0].equal_to, -1);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(plan.tiles[i].equal_to, 0) << i;
    EXPECT_FALSE(plan.tiles[2].mirrored);
    EXPECT_TRUE(plan.tiles[3].mirrored);
    const std::vector<Quantity> cut = quantities(plan);
    EXPECT_EQ(cut[0].same, 3);
    EXPECT_EQ(cut[0].mirrored, 1);
    EXPECT_EQ(cut[1].same + cut[1].mirrored, 0);
    for (const FlatTile& tile : plan.tiles) {
        EXPECT_NEAR(tile.accuracy.energy, plan.tiles[0].accuracy.energy, 1e-9 * plan.tiles[0].accuracy.energy);
        EXPECT_EQ(tile.verdict.manufacturable(), plan.tiles[0].verdict.manufacturable());
        EXPECT_NEAR(tile.bounds.stretch_ratio, measure_bounds(tile.tile).stretch_ratio, 1e-6);
        EXPECT_NEAR((tile.bounds.centre - measure_bounds(tile.tile).centre).norm(), 0, 1e-6);
    }
}

TEST(EqualPieces, OfAnEnvelopeAreEachPanelOncePerGore) {
    FlattenOptions options;
    options.fabric = fabric_named("polyester");
    const CutPlan plan =
        flatten_envelope(make_envelope(design_natural({.gores = 12, .panels = 4, .edge_length = 0.6}), {}), options);
    const std::vector<Quantity> cut = quantities(plan);
    for (std::size_t i = 0; i < cut.size(); ++i) EXPECT_EQ(cut[i].same + cut[i].mirrored, i < 4 ? 12 : 0) << i;
}

TEST(EqualPieces, CutDifferentlyAreNotListed) {
    std::vector<Tile> tiles = four_alike();
    tiles.resize(2);
    for (Tile& tile : tiles) tile.drawn = tile.mesh.positions.leftCols(2);
    // judged as given: the second is rotated in space, so its x and y are another piece
    const CutPlan plan = flatten_envelope({tiles}, {.method = "given"});
    EXPECT_EQ(plan.tiles[1].equal_to, -1);
}

}  // namespace equal_pieces_test
}  // namespace ripstop
