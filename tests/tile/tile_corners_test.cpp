#include <gmock/gmock.h>

#include "ripstop/base/error.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace tile_corners_test {

TEST(TileCorners, AreTheBoundaryVerticesNearestToThePointsGiven) {
    TileOptions options;
    options.corners = {{0.01, 0, 0}, {2.02, 1, 0}};
    const Tile tile = make_tile("sheet", testing::rectangle(2, 1, 8, 4), options);
    ASSERT_EQ(tile.chains.size(), 2U);
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(2, 1, 0)}) {
        const auto starts_there = [&](const Chain& chain) {
            return (Vec3(tile.mesh.positions.row(chain.vertices.front())) - corner).norm() < 1e-12;
        };
        EXPECT_TRUE(std::any_of(tile.chains.begin(), tile.chains.end(), starts_there));
    }
}

TEST(TileCorners, AreRefusedFarOffTheBoundary) {
    TileOptions options;
    options.corners = {{0, 0, 0}, {2, 1, 5}};
    try {
        make_tile("sheet", testing::rectangle(2, 1, 8, 4), options);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith(
                                      "tile sheet: its corner (2.000, 1.000, 5.000) m is 5.000 m off its boundary"));
    }
}

}  // namespace tile_corners_test
}  // namespace ripstop
