/// Figures printed in the paper, and those of its method on the kinds of tiles it names.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "ripstop/flatten/spring/kubicek_zemcik.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace paper_test {

Accuracy flattened(const Tile& tile, const Fabric& fabric = {}) {
    return measure_accuracy(tile, flatten_kubicek_zemcik(tile, fabric).positions, fabric);
}

TEST(Paper, RuledConeIsFarBelowItsTable1) {
    // printed: area 0.07 %, shape 0.0055 %
    const Accuracy found = flattened(make_tile("cone", testing::cone(0.4, 2.4, 0.5, 2, 24, 16)));
    EXPECT_LT(std::abs(found.area_error), 1e-8);
    EXPECT_LT(std::abs(found.perimeter_error), 1e-8);
}

TEST(Paper, RuledCylinderIsExact) {
    const Accuracy found = flattened(make_tile("cylinder", testing::cylinder(2, 1.1, 1.5, 20, 16)));
    EXPECT_LT(std::abs(found.area_error), 1e-8);
    EXPECT_LT(std::abs(found.perimeter_error), 1e-8);
}

TEST(Paper, StaggeredConeIsSecondOrderInTheEdgeLength) {
    const auto error = [](int n) {
        return flattened(make_tile("cone", testing::staggered_cone(0.4, 2.4, 0.5, 2, 3 * n, 2 * n))).edge_error_abs;
    };
    const double coarse = error(6), fine = error(12);
    EXPECT_LT(coarse, 0.002);
    EXPECT_GT(std::log2(coarse / fine), 1.7);
}

TEST(Paper, QuarterSphereIsRefusedWithErrorsOfThePrintedOrder) {
    // printed: area 1.93 %, shape 14.01 %. Here a 90 degree lune, warp from pole to pole, isotropic.
    const Tile tile = make_tile("quarter", testing::lune(std::numbers::pi / 2, 24, 48), {.warp = Vec3::UnitZ()});
    const Fabric fabric;
    const Flattening flat = flatten_kubicek_zemcik(tile, fabric);
    const Accuracy found = measure_accuracy(tile, flat.positions, fabric);
    EXPECT_EQ(found.flipped, 0);
    EXPECT_GT(found.perimeter_error, 0.09);
    EXPECT_LT(found.perimeter_error, 0.16);
    EXPECT_LT(std::abs(found.area_error), 0.03);
    const Verdict verdict = judge(tile, measure_bounds(tile), flat, found, tolerances_of(fabric));
    EXPECT_FALSE(verdict.manufacturable());
}

TEST(Paper, AdaptiveStepReachesTheSameRestSooner) {
    const Tile tile = make_tile("gore", testing::lune(2 * std::numbers::pi / 24, 8, 64), {.warp = Vec3::UnitZ()});
    const Flattening fixed = flatten_kubicek_zemcik(tile, Fabric{});
    const Flattening adaptive = flatten_kubicek_zemcik(tile, Fabric{}, {.adaptive = true});
    EXPECT_EQ(adaptive.summary.termination, Termination::converged);
    EXPECT_LT(adaptive.summary.iterations, fixed.summary.iterations);
    const double a = measure_accuracy(tile, fixed.positions, Fabric{}).perimeter_error;
    const double b = measure_accuracy(tile, adaptive.positions, Fabric{}).perimeter_error;
    EXPECT_NEAR(a, b, 1e-4);
}

TEST(Paper, FreeGoreIsAsMuchTooLongAsGeometryDemands) {
    // any good free flattening of a gore of angle b: perimeter + b^2 / 24
    const double beta = 2 * std::numbers::pi / 24;
    const Accuracy found = flattened(make_tile("gore", testing::lune(beta, 8, 96), {.warp = Vec3::UnitZ()}));
    EXPECT_NEAR(found.perimeter_error, beta * beta / 24, 0.15 * beta * beta / 24);
}

CutPlan plan_of(const std::filesystem::path& file, const std::string& method, double metres_per_unit = 1) {
    const Envelope envelope = read_envelope(file, {.unit = LengthUnit{"", metres_per_unit}});
    FlattenOptions options;
    options.method = method;
    return flatten_envelope(envelope, options);
}

TEST(PaperOnRealInput, SkirtIsBelowThePublishedFlattening) {
    RIPSTOP_REQUIRE_SHARED(file, "skirt/skirt__skirt_3D_0.obj");
    const CutPlan plan = plan_of(file, "paper", 0.01);
    ASSERT_EQ(plan.tiles.size(), 1u);
    const Accuracy& found = plan.tiles[0].accuracy;
    EXPECT_EQ(found.flipped, 0);
    EXPECT_LT(found.area_error_abs, 0.0287);
    EXPECT_LT(found.edge_error_abs, 0.0203);
    EXPECT_LT(found.boundary_error_abs, 0.0302);
}

TEST(PaperOnRealInput, DressPanelsComeOutWithoutAFlip) {
    RIPSTOP_TOO_LONG_SANITIZED();
    RIPSTOP_REQUIRE_SHARED(file, "dress/dress_knife_drape_3d.obj");
    const CutPlan ours = plan_of(file, "paper");
    const CutPlan drawn = plan_of(file, "given");
    ASSERT_EQ(ours.tiles.size(), 14u);
    for (std::size_t i = 0; i < ours.tiles.size(); ++i) {
        SCOPED_TRACE(ours.tiles[i].tile.name);
        EXPECT_EQ(ours.tiles[i].accuracy.flipped, 0) << ours.tiles[i].flattening.summary.text();
        // the drape is cloth under load: flattening it must distort less than returning to the true pattern
        EXPECT_LT(ours.tiles[i].accuracy.edge_error_abs, drawn.tiles[i].accuracy.edge_error_abs);
    }
}

TEST(PaperOnRealInput, PlanarPanelsComeBackCongruentAndSpikesAreReported) {
    RIPSTOP_TOO_LONG_SANITIZED();
    RIPSTOP_REQUIRE_SHARED(file, "dress/dress_knife_design_stage_3d.obj");
    const CutPlan plan = plan_of(file, "paper");
    int congruent = 0, reported = 0;
    for (const FlatTile& tile : plan.tiles) {
        if (tile.accuracy.boundary_error_max < 1e-9 && tile.accuracy.edge_error_abs < 1e-9) {
            ++congruent;
            EXPECT_TRUE(tile.verdict.manufacturable()) << tile.tile.name;
        } else {
            ++reported;
            EXPECT_FALSE(tile.verdict.findings.empty()) << tile.tile.name;
        }
    }
    EXPECT_EQ(congruent, 12);
    EXPECT_EQ(reported, 2);
}

}  // namespace paper_test
}  // namespace ripstop
