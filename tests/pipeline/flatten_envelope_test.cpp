/// Whole envelopes, designed and real, flattened by the default method.
#include "ripstop/pipeline/flatten/flatten_envelope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/design/natural/gores.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/measure/judge.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/sewn.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace flatten_envelope_test {

CutPlan flatten(const Envelope& envelope, const std::string& fabric, const std::string& method = "seam-exact") {
    FlattenOptions options;
    options.method = method;
    options.fabric = fabric_named(fabric);
    options.tolerances = tolerances_of(options.fabric);
    return flatten_envelope(envelope, options);
}

/// The balloon of 24 x 15, coarser than the default to make the test quick. `grain_turn` rotates the warp from
/// along the gore to the bias.
Envelope balloon(double grain_turn = 0) {
    return make_envelope(design_natural({.edge_length = 0.25}), {.grain_turn = grain_turn});
}

TEST(Balloon, EveryPanelIsMadeWithItsSeamsExact) {
    for (const char* fabric : {"isotropic", "nylon", "polyester"}) {
        const CutPlan plan = flatten(balloon(), fabric);
        ASSERT_EQ(plan.tiles.size(), 360u);
        std::vector<int> factorizations;
        for (const FlatTile& tile : plan.tiles) {
            SCOPED_TRACE(tile.tile.name + " " + fabric);
            EXPECT_TRUE(tile.verdict.manufacturable());
            EXPECT_LT(tile.accuracy.boundary_error_max, 1e-8);
            EXPECT_LE(std::abs(tile.accuracy.area_error), 0.01);
            factorizations.push_back(tile.flattening.summary.factorizations);
        }
        std::nth_element(factorizations.begin(), factorizations.begin() + 180, factorizations.end());
        EXPECT_LE(factorizations[180], 8);
    }
}

TEST(Balloon, ClothThatShearsKeepsTheAreaToATenthOfAPerCent) {
    for (const char* fabric : {"nylon", "polyester"})
        for (const FlatTile& tile : flatten(balloon(), fabric).tiles)
            EXPECT_LT(std::abs(tile.accuracy.area_error), 0.001) << tile.tile.name << " " << fabric;
}

TEST(Balloon, OnTheBiasTheAreaCanBeHeldToo) {
    for (const char* fabric : {"nylon", "polyester"})
        for (const FlatTile& tile : flatten(balloon(45 * degree), fabric, "seam-exact-area").tiles) {
            EXPECT_LT(std::abs(tile.accuracy.area_error), 1e-9) << tile.tile.name << " " << fabric;
            EXPECT_TRUE(tile.verdict.manufacturable()) << tile.tile.name;
        }
}

TEST(Balloon, NeighboursCutApartHaveSeamsOfTheSameLength) {
    const CutPlan plan = flatten(balloon(), "nylon");
    // the upper edge of G01P05 and the lower one of G01P06 are one seam: each flat length occurs once in both
    const auto lengths = [&](const std::string& name) {
        for (const FlatTile& tile : plan.tiles)
            if (tile.tile.name == name) return tile.accuracy.chains;
        throw std::runtime_error(name);
    };
    double nearest = 1;
    for (const ChainAccuracy& a : lengths("G01P05"))
        for (const ChainAccuracy& b : lengths("G01P06"))
            nearest = std::min(nearest, std::abs(a.flat_length - b.flat_length));
    EXPECT_LT(nearest, 1e-8);
}

/// The same with seams; its tiles share the places of their vertices.
Envelope sewn_balloon() {
    Envelope envelope = balloon();
    envelope.seams = testing::conforming_seams(envelope.tiles);
    return envelope;
}

double total_energy(const CutPlan& plan) {
    double sum = 0;
    for (const FlatTile& tile : plan.tiles) sum += tile.accuracy.energy;
    return sum;
}

std::vector<Points2> flat_positions(const CutPlan& plan) {
    std::vector<Points2> flats;
    for (const FlatTile& tile : plan.tiles) flats.push_back(tile.flattening.positions);
    return flats;
}

TEST(Balloon, MatchedSeamsAreEquallyLongOnBothSidesAndStrainTheClothLess) {
    const Envelope envelope = sewn_balloon();
    ASSERT_EQ(envelope.seams.size(), 24u * 15 + 24 * 14);
    for (const char* fabric : {"isotropic", "nylon"}) {
        const CutPlan exact = flatten(envelope, fabric), matched = flatten(envelope, fabric, "seam-matched");
        EXPECT_LT(testing::worst_drift(envelope, flat_positions(matched)), 1e-10);
        EXPECT_LT(total_energy(matched), 0.75 * total_energy(exact));
        for (const FlatTile& tile : matched.tiles) {
            EXPECT_EQ(tile.flattening.summary.termination, Termination::converged) << tile.tile.name;
            EXPECT_TRUE(tile.flattening.certificate->strict_minimum) << tile.tile.name;
            EXPECT_LE(std::abs(tile.accuracy.area_error), 1e-4) << tile.tile.name;
        }
    }
}

TEST(Balloon, SeamsMatchedWithinTheToleranceAreJudgedManufacturable) {
    const Envelope envelope = sewn_balloon();
    const CutPlan exact = flatten(envelope, "isotropic"), tight = flatten(envelope, "isotropic", "seam-matched-0.1");
    EXPECT_LT(testing::worst_drift(envelope, flat_positions(tight)), 1e-10);
    EXPECT_LT(total_energy(tight), 0.6 * total_energy(exact));
    for (const FlatTile& tile : tight.tiles) EXPECT_TRUE(tile.verdict.manufacturable()) << tile.tile.name;
}

TEST(QuarterSphere, IsRefusedWithReasons) {
    const Envelope envelope = make_envelope({{"quarter", testing::lune(1.5707963267948966, 12, 24), {}}}, {});
    const CutPlan plan = flatten(envelope, "isotropic");
    const FlatTile& tile = plan.tiles.front();
    EXPECT_FALSE(tile.verdict.manufacturable());
    std::vector<std::string> codes;
    for (const Finding& finding : tile.verdict.findings) {
        codes.push_back(finding.code);
        EXPECT_FALSE(finding.message.empty());
    }
    EXPECT_NE(std::find(codes.begin(), codes.end(), "area"), codes.end());
    EXPECT_NE(std::find(codes.begin(), codes.end(), "warp_strain"), codes.end());
}

TEST(RealInput, DressAndSkirtHaveExactSeamsAndNoFlip) {
    RIPSTOP_REQUIRE_SHARED(dress, "dress/dress_knife_drape_3d.obj");
    RIPSTOP_REQUIRE_SHARED(skirt, "skirt/skirt__skirt_3D_0.obj");
    for (const CutPlan& plan : {flatten(read_envelope(dress, {}), "isotropic"),
                                flatten(read_envelope(skirt, {.unit = LengthUnit{"cm", 0.01}}), "isotropic")})
        for (const FlatTile& tile : plan.tiles) {
            SCOPED_TRACE(tile.tile.name);
            EXPECT_LT(tile.accuracy.boundary_error_max, 1e-8);
            EXPECT_EQ(tile.accuracy.flipped, 0);
            EXPECT_TRUE(tile.flattening.certificate && tile.flattening.certificate->strict_minimum);
        }
}

TEST(RealInput, PlanarPanelsComeBackCongruent) {
    RIPSTOP_REQUIRE_SHARED(file, "dress/dress_knife_design_stage_3d.obj");
    const CutPlan plan = flatten(read_envelope(file, {}), "isotropic");
    int congruent = 0;
    for (const FlatTile& tile : plan.tiles) {
        if (tile.accuracy.edge_error_abs < 1e-9)
            ++congruent;
        else
            EXPECT_FALSE(tile.verdict.manufacturable()) << tile.tile.name;
    }
    EXPECT_EQ(congruent, 12);
}

}  // namespace flatten_envelope_test
}  // namespace ripstop
