/// Properties of the inflation of a whole plan, for any load and any cut.
#include "ripstop/pipeline/flight/inflate_plan.h"

#include <gmock/gmock.h>

#include "ripstop/base/error.h"
#include "ripstop/report/words/inflated_says.h"
#include "support/balloons.h"

namespace ripstop {
namespace inflate_plan_test {

using ::testing::Contains;
using ::testing::HasSubstr;

EnvelopeDesign small() {
    return {.gores = 12, .panels = 6, .volume = 300, .edge_length = 0.6};
}

InflatePlanOptions without_causes() {
    InflatePlanOptions options;
    options.find_causes = false;
    return options;
}

TEST(InflatePlan, ClothThatHasShrunkBearsWhatClothCutToSizeBears) {
    const Inflated to_size = inflate_plan(testing::cut_balloon(small(), false), without_causes());
    CutPlan plan = testing::cut_balloon(small(), false);
    constexpr double area = 1.02 * 1.02;
    plan.fabric.mass /= area;
    for (FlatTile& tile : plan.tiles) {
        if (tile.tile.fabric) tile.tile.fabric->mass /= area;
        tile.tile.compensation.warp = 0.02;
        tile.tile.compensation.weft = 0.02;
        tile.flattening.positions *= 1.02;
    }
    const Inflated shrunk = inflate_plan(plan, without_causes());
    ASSERT_EQ(shrunk.summary.termination, Termination::converged);
    EXPECT_NEAR(shrunk.off.moved_rms, to_size.off.moved_rms, 1e-5);
    EXPECT_NEAR(shrunk.tension_max, to_size.tension_max, 1e-3 * to_size.tension_max);
    EXPECT_NEAR(shrunk.wrinkled, to_size.wrinkled, 1e-2);
    EXPECT_NEAR(shrunk.cloth_mass, to_size.cloth_mass, 1e-9 * to_size.cloth_mass);
    EXPECT_NEAR(shrunk.lift, to_size.lift, 0.01);  // the valve was made as light as the cloth
}

TEST(InflatePlan, ATieIsOneHoweverManySectorsTheClothHas) {
    const CutPlan plan = testing::cut_balloon(small(), false);
    InflatePlanOptions options = without_causes();
    EXPECT_EQ(inflate_plan(plan, options).sectors, 12);
    const Vec3 from = plan.tiles[2].tile.mesh.positions.row(0), to(-from.x(), -from.y(), from.z());
    options.rigging.ties = {{"waist", from, to}};
    const Inflated tied = inflate_plan(plan, options);
    EXPECT_EQ(tied.sectors, 1);
    EXPECT_NEAR(tied.tape_mass, (to - from).norm() * options.rigging.ties[0].material.mass, 1e-12);
}

TEST(InflatePlan, VolumeAndLiftAreTheGassWhereverItHasNoPressure) {
    const CutPlan plan = testing::cut_balloon(small(), false);
    const Inflated plain = inflate_plan(plan, without_causes());
    InflatePlanOptions lower = without_causes(), pressed = without_causes(), open = without_causes();
    lower.load.mouth_plane = plain.floor - 2;
    pressed.load.extra_pressure = 15;
    open.rigging.crown_closed = false;
    for (const InflatePlanOptions& options : {lower, pressed, open})
        EXPECT_NEAR(inflate_plan(plan, options).drawn_volume, plain.drawn_volume, 1e-9 * plain.drawn_volume);
    for (const InflatePlanOptions& options : {lower, pressed}) {
        const Inflated found = inflate_plan(plan, options);
        EXPECT_LT(std::abs(found.imbalance), 1e-6);
        EXPECT_NEAR(found.lift - plain.lift, plain.rise * (found.volume - plain.volume), 1e-3) << "b V - W, no thrust";
    }
}

TEST(InflatePlan, SaysThatGasThatDoesNotCarryTheClothDoesNot) {
    CutPlan plan = testing::cut_balloon(small(), false);
    InflatePlanOptions cold;
    cold.load.air.inside = 16;
    plan.inflated = inflate_plan(plan, cold);
    EXPECT_FALSE(plan.inflated->stands());
    EXPECT_FALSE(plan.inflated->is_safe());
    EXPECT_FALSE(plan.inflated->causes);
    EXPECT_THAT(inflated_says(plan), Contains(HasSubstr("It does not stand: at 16 C inside")));
}

TEST(InflatePlan, RefusesClothThatDoesNotEncloseTheGas) {
    CutPlan plan = testing::cut_balloon(small(), false);
    plan.tiles.resize(6);
    std::erase_if(plan.seams, [](const Seam& seam) { return seam.a.tile >= 6 || seam.b.tile >= 6; });
    plan.walks.clear();
    try {
        inflate_plan(plan, {});
        FAIL() << "one gore was inflated";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("does not enclose the gas"));
    }
}

// A cancelled inflation leaves no results.
TEST(InflatePlan, CanBeCalledOff) {
    struct CalledOff {};
    InflatePlanOptions options;
    int steps = 0;
    options.progress = [&](double, const std::string&) {
        if (++steps == 3) throw CalledOff{};
    };
    const CutPlan plan = testing::cut_balloon(small(), false);
    EXPECT_THROW(inflate_plan(plan, options), CalledOff);
    EXPECT_EQ(steps, 3);
    EXPECT_FALSE(plan.inflated);
}

}  // namespace inflate_plan_test
}  // namespace ripstop
