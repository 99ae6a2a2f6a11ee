#include "ripstop/report/view/map_view.h"

#include <gmock/gmock.h>

#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/pipeline/flatten/strain_maps.h"
#include "ripstop/report/view/first_tile.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/tile/targets.h"
#include "support/flat_tiles.h"
#include "support/inflated.h"
#include "support/seams.h"

namespace ripstop {
namespace map_view_test {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::HasSubstr;

/// A sheet of two triangles with the same strain along the warp.
CutPlan sheet() {
    Points2 corners(4, 2);
    corners << 0, 0, 2, 0, 2, 2, 0, 2;
    CutPlan plan;
    plan.tiles = {testing::flat_polygon("sheet", corners)};
    return plan;
}

std::vector<StrainMap> strain_of(const std::vector<double>& warp) {
    const Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd>(warp.data(), static_cast<Eigen::Index>(warp.size()));
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(values.size());
    return {{values, none, none, none}};
}

const MapScale& scale_of(const MapView& view, std::string_view id) {
    for (const MapScale& scale : view.scales)
        if (scale.id == id) return scale;
    throw std::logic_error("no such scale");
}

TEST(MapView, IsScaledToWhatThereIsUntilSomethingLiesBeyondWhatIsAllowed) {
    for (const auto& [most, opens, end] : {std::tuple{0.0, "there", 0.0002},
                                           {0.00031, "there", 0.0005},
                                           {-0.0011, "there", 0.002},
                                           {0.02, "there", 0.02},
                                           {0.0201, "tolerance", 0.02},
                                           {-0.3, "tolerance", 0.02}}) {
        const MapView view = map_view(sheet(), strain_of({most, most}), page_map("warp"));
        ASSERT_EQ(view.scales.size(), 2u);
        EXPECT_EQ(view.scales[0].id, opens) << most;
        EXPECT_NEAR(view.scales[0].cloth[0], end, 1e-12) << most;
        EXPECT_EQ(view.scales[0].has_beyond, view.scales[0].id == "tolerance");
    }
}

TEST(MapView, LeavesOneTriangleInAHundredBeyondTheEndsOfWhatThereIs) {
    CutPlan plan;
    plan.tiles.assign(200, sheet().tiles[0]);
    std::vector<StrainMap> strains(200, strain_of({0.0004, -0.0004})[0]);
    strains[7] = strain_of({0.019, 0.0004})[0];
    const MapView view = map_view(plan, strains, page_map("warp"));
    EXPECT_NEAR(view.scales[0].cloth[0], 0.0005, 1e-12);
    EXPECT_THAT(view.scales[0].note, HasSubstr("at most 1.9 %"));
    EXPECT_EQ(cloth_places(plan, view, 7)[0], page_places::first + page_places::steps - 1)
        << "in the colour of the end";
    EXPECT_EQ(view.scales[0].high, "+0.05 %");
}

TEST(MapView, TellsTheShareOfAnEdgeByItsLength) {
    const CutPlan plan = testing::unevenly_meshed_plan();
    const std::vector<Eigen::VectorXd> edges = edge_values(plan, page_map("mismatch"));
    // Side b is ahead by 0.001 of the distance: at the edges' midpoints, 50 and 550 mm, by 0.05 and 0.55 mm.
    for (std::size_t tile = 0; tile < 2; ++tile) {
        const Eigen::VectorXd drawn = drawn_lengths(plan.tiles[tile].tile);
        int sewn = 0;
        for (Eigen::Index i = 0; i < drawn.size(); ++i) {
            if (std::isnan(edges[tile][i])) continue;
            EXPECT_NEAR(edges[tile][i], (tile == 0 ? -1e-3 : 1e-3) * (drawn[i] < 0.5 ? 0.05 : 0.55), 1e-9);
            ++sewn;
        }
        EXPECT_EQ(sewn, 2) << tile;
    }
}

/// By hand: 0.3 % of 10 m; 10 kN/m x 20.4 x 70 / (5 x 10 kN/m); the fabric's limits; 150 N x 23.8 / 5.
TEST(MapView, IsPinnedToWhatIsAllowedInEveryMap) {
    const CutPlan plan = testing::inflated_plan();
    const double stress = 20.4 * 70 / 5;
    const auto all_end = [&](const char* id, double end) {
        const MapView view = map_view(plan, measure_strain_maps(plan), page_map(id));
        EXPECT_THAT(scale_of(view, "tolerance").cloth, Each(DoubleNear(end, 1e-9 * end))) << id;
    };
    for (const char* id : {"warp", "weft", "edges", "flight-strain-warp", "flight-strain-weft"})
        all_end(id, plan.fabric.strain_limit);
    for (const char* id : {"shear", "flight-strain-shear"}) all_end(id, plan.fabric.shear_limit);
    for (const char* id : {"flight-tension", "flight-warp", "flight-weft", "flight-shear"}) all_end(id, stress);
    all_end("area", 0.01);
    all_end("deviation", 0.03);
    for (const auto& [id, end] : {std::pair{"edges", 0.001}, {"mismatch", 0.001}, {"tapes", 150 * 23.8 / 5}})
        EXPECT_NEAR(scale_of(map_view(plan, {}, page_map(id)), "tolerance").edges, end, 1e-9 * end) << id;
}

TEST(MapView, HasOneScaleForAllStressesOfTheCloth) {
    const CutPlan plan = testing::inflated_plan();
    for (const char* id : {"flight-tension", "flight-warp", "flight-weft", "flight-shear"})
        EXPECT_THAT(scale_of(map_view(plan, {}, page_map(id)), "there").cloth, Each(DoubleNear(50, 1e-9))) << id;
}

TEST(MapView, OfForcesThatNothingLimitsEndsAtTheLargest) {
    CutPlan plan = testing::two_tile_plan();
    const auto count = static_cast<Eigen::Index>(plan.tiles[1].tile.boundary.size());
    plan.tiles[1].flattening.seam_tension = Eigen::VectorXd::LinSpaced(count, -137.5, 20);
    const MapView view = map_view(plan, {}, page_map("tension"));
    ASSERT_EQ(view.scales.size(), 1u);
    EXPECT_NEAR(view.scales[0].edges, 200, 1e-9);
    EXPECT_EQ(view.scales[0].low, "−200 N");
    EXPECT_THAT(edge_places(view, 0), Each(page_places::unknown)) << "of the other tile nothing is known";
}

TEST(FirstTile, IsTheWorst) {
    CutPlan plan;
    plan.tiles.assign(3, sheet().tiles[0]);
    for (FlatTile& tile : plan.tiles) tile.verdict.judged = true;
    std::vector<StrainMap> strains(3, strain_of({0.0004, 0})[0]);
    strains[1] = strain_of({0, -0.0006})[0];
    EXPECT_EQ(first_tile(plan, map_view(plan, strains, page_map("warp"))), 1) << "all can be made: of the map";
    plan.tiles[0].verdict.findings = {{"area", "", Vec3::Zero(), 1.1, 1}};
    plan.tiles[2].verdict.findings = {{"area", "", Vec3::Zero(), 1.05, 1}, {"chain", "", Vec3::Zero(), -0.3, 0.1}};
    EXPECT_EQ(first_tile(plan, map_view(plan, strains, page_map("warp"))), 2) << "three times what is allowed";
    EXPECT_EQ(first_tile(CutPlan(), map_view(CutPlan(), {}, page_map("edges"))), -1);
}

TEST(FirstTile, IsASideOfTheWorstSeamWhereOnlySeamsFail) {
    CutPlan plan = testing::sewn_plan();
    for (FlatTile& tile : plan.tiles) tile.verdict.judged = true;
    EXPECT_EQ(first_tile(plan, map_view(plan, {}, page_map("mismatch"))), plan.seams[1].a.tile);
}

TEST(FirstTile, OfEqualOnesFacesTheViewer) {
    CutPlan plan;
    plan.tiles.assign(2, sheet().tiles[0]);
    for (FlatTile& tile : plan.tiles) {
        tile.verdict.judged = true;
        tile.tile.mesh.positions.col(2) = tile.tile.mesh.positions.col(1).eval();
        tile.tile.mesh.positions.col(1).setZero();
    }
    plan.tiles[0].tile.mesh.positions.col(0) *= -1;  // turned over: it faces the back
    const std::vector<StrainMap> strains(2, strain_of({0.0004, 0.0004})[0]);
    EXPECT_EQ(first_tile(plan, map_view(plan, strains, page_map("warp"))), 1);
}

}  // namespace map_view_test
}  // namespace ripstop
