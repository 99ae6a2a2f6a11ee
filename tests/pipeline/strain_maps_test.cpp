#include "ripstop/pipeline/flatten/strain_maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "support/flat_tiles.h"
#include "support/sewn.h"

namespace ripstop {
namespace strain_maps_test {

TEST(StrainMaps, ReachTheLargestStrainsOfTheReport) {
    FlattenOptions options;
    options.method = "lscm";
    const CutPlan plan = flatten_envelope(testing::gores({0.5}, 2, 4, 12), options);
    const std::vector<StrainMap> maps = measure_strain_maps(plan);
    ASSERT_EQ(maps.size(), plan.tiles.size());
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const Accuracy& accuracy = plan.tiles[i].accuracy;
        EXPECT_DOUBLE_EQ(maps[i].warp.maxCoeff(), accuracy.warp_strain_max);
        EXPECT_DOUBLE_EQ(maps[i].warp.minCoeff(), accuracy.warp_strain_min);
        EXPECT_DOUBLE_EQ(maps[i].weft.maxCoeff(), accuracy.weft_strain_max);
        EXPECT_DOUBLE_EQ(maps[i].shear.cwiseAbs().maxCoeff(), accuracy.shear_max);
    }
}

TEST(StrainMaps, SayWhereTheClothIsTurnedOver) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].flattening.positions.col(1) *= -1;
    const std::vector<StrainMap> maps = measure_strain_maps(plan);
    for (const double strain : maps[0].warp) EXPECT_TRUE(std::isnan(strain));
    for (const double strain : maps[1].warp) EXPECT_FALSE(std::isnan(strain));
}

TEST(StrainMaps, AreEmptyForATileWithoutFlatPositions) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[1].flattening = {};
    const std::vector<StrainMap> maps = measure_strain_maps(plan);
    EXPECT_GT(maps[0].warp.size(), 0);
    EXPECT_EQ(maps[1].warp.size(), 0);
}

}  // namespace strain_maps_test
}  // namespace ripstop
