#include "ripstop/pipeline/flight/compensate.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ripstop/energy/deformation.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/pipeline/flight/wanted_cloth.h"
#include "ripstop/tile/targets.h"
#include "support/balloons.h"
#include "support/sanitized.h"

namespace ripstop {
namespace compensate_test {

using namespace testing;

/// The largest relative length difference between the two sides of a seam.
double worst_seam(const CutPlan& plan) {
    double worst = 0;
    for (const SeamWalk& walk : plan.walks) worst = std::max(worst, walk.drift_max / walk.length);
    return worst;
}

CompensateOptions nylon_options() {
    CompensateOptions options;
    options.flatten.fabric = fabric_named("nylon");
    return options;
}

TEST(Compensate, SmoothEnvelopeInflatesToTheDrawnShape) {
    const EnvelopeDesign design{.gores = 24, .panels = 12, .edge_length = 0.5};
    const CutPlan plan = compensate(balloon(design), nylon_options());
    ASSERT_TRUE(plan.inflated.has_value());
    const Inflated& inflated = *plan.inflated;
    const CompensationRound& before = plan.rounds.front();
    EXPECT_EQ(before.step, "as drawn");
    EXPECT_NEAR(before.off.moved_rms, 0.125, 0.03);  // the stretch of real cloth; the prototype's design has 0.148
    EXPECT_LT(inflated.off.moved_rms, 1e-3 * inflated.drawn_height);
    EXPECT_NEAR(inflated.volume, inflated.drawn_volume, 3e-3 * inflated.drawn_volume);
    EXPECT_NEAR(inflated.height, inflated.drawn_height, 6e-3 * inflated.drawn_height);
    EXPECT_LT(worst_seam(plan), 1e-3);
    for (const FlatTile& tile : plan.tiles) EXPECT_TRUE(tile.verdict.manufacturable()) << tile.tile.name;
}

TEST(Compensate, LobedEnvelopeWithShorterTapesInflatesToTheDrawnShape) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const EnvelopeDesign design{.gores = 24, .panels = 6, .bulge = 20 * degree, .edge_length = 0.8};
    CompensateOptions options = nylon_options();
    options.tapes = TapedSeams::meridians;
    options.inflate.rigging.foreshortening = 0.02;
    const CutPlan plan = compensate(balloon(design), options);
    const Inflated& inflated = *plan.inflated;
    EXPECT_GT(plan.rounds.front().off.moved_rms, 0.2);  // the tapes pull it down
    EXPECT_LT(inflated.off.moved_rms, 1e-3 * inflated.drawn_height);
    EXPECT_NEAR(inflated.volume, inflated.drawn_volume, 3e-3 * inflated.drawn_volume);
    EXPECT_LT(worst_seam(plan), 1e-3);
    ASSERT_EQ(plan.tape_factors.size(), plan.seams.size());
}

TEST(Compensate, KeepsTheBestRound) {
    const EnvelopeDesign design{.gores = 12, .panels = 4, .edge_length = 1};
    const CutPlan plan = compensate(balloon(design), nylon_options());
    const auto& rounds = plan.rounds;
    const auto best = std::min_element(rounds.begin(), rounds.end(),
                                       [](const auto& a, const auto& b) { return a.off.moved_rms < b.off.moved_rms; });
    EXPECT_TRUE(best->is_best);
    EXPECT_EQ(std::count_if(rounds.begin(), rounds.end(), [](const auto& round) { return round.is_best; }), 1);
    EXPECT_EQ(plan.inflated->off.moved_rms, best->off.moved_rms);
}

TEST(WantedCloth, OfTheDrawingItselfChangesNothing) {
    const Envelope drawn = balloon({.gores = 6, .panels = 2, .edge_length = 1.5});
    Envelope cut = drawn;
    compensate_tiles(drawn_cloth(drawn), cut);
    for (std::size_t i = 0; i < drawn.tiles.size(); ++i) {
        EXPECT_LT(cut.tiles[i].compensation.strain.cwiseAbs().maxCoeff(), 1e-13);
        EXPECT_LT((target_lengths(cut.tiles[i]) - target_lengths(drawn.tiles[i])).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(WantedCloth, IsCutShorterByTheStrainItIsToBear) {
    const Envelope drawn = balloon({.gores = 6, .panels = 2, .edge_length = 1.5});
    Envelope cut = drawn;
    WantedCloth wanted = drawn_cloth(drawn);
    for (Points3& strain : wanted.strain) strain.col(0).setConstant(0.5 * (1.01 * 1.01 - 1));
    compensate_tiles(wanted, cut);
    for (std::size_t i = 0; i < drawn.tiles.size(); ++i) {
        const std::vector<Mat22> before = target_triangles(drawn.tiles[i]), after = target_triangles(cut.tiles[i]);
        const Eigen::Matrix2Xd warp = warp_in_triangles(drawn.tiles[i]);
        for (std::size_t t = 0; t < before.size(); ++t) {
            // The map from cloth to surface: 1.01 along the warp, 1 across.
            const Mat22 F = before[t] * after[t].inverse();
            const Vec2 along = warp.col(static_cast<Eigen::Index>(t)), across(-along.y(), along.x());
            const Mat22 C = F.transpose() * F;
            EXPECT_NEAR(along.dot(C * along), 1.01 * 1.01, 1e-12);
            EXPECT_NEAR(across.dot(C * across), 1, 1e-12);
            EXPECT_NEAR(along.dot(C * across), 0, 1e-12);
        }
    }
}

TEST(WantedCloth, OfALargerTargetIsLargerAndItsSeamsStillFit) {
    const Envelope drawn = balloon({.gores = 6, .panels = 2, .edge_length = 1.5});
    Envelope cut = drawn;
    WantedCloth wanted = drawn_cloth(drawn);
    for (Points3& target : wanted.target) target *= 1.03;
    wanted.tape_strain.assign(drawn.seams.size(), 0.005);
    compensate_tiles(wanted, cut);
    for (std::size_t i = 0; i < drawn.tiles.size(); ++i) {
        const Eigen::VectorXd ratio = target_lengths(cut.tiles[i]).cwiseQuotient(target_lengths(drawn.tiles[i]));
        EXPECT_LT((ratio.array() - 1.03).abs().maxCoeff(), 1e-12);
    }
    for (const double factor : tape_factors(wanted, drawn)) EXPECT_NEAR(factor, 1.03 / std::sqrt(1.01), 1e-12);
}

TEST(WantedCloth, BothSidesOfASeamAreCutAlikeWhateverTheirTilesAskFor) {
    const Envelope drawn = balloon({.gores = 6, .panels = 2, .edge_length = 1.5});
    Envelope cut = drawn;
    WantedCloth wanted = drawn_cloth(drawn);
    for (std::size_t i = 0; i < drawn.tiles.size(); ++i)
        for (Eigen::Index t = 0; t < wanted.strain[i].rows(); ++t)
            wanted.strain[i].row(t) << 0.01 * std::sin(3.0 * static_cast<double>(i) + static_cast<double>(t)), 0.005,
                0.002;
    compensate_tiles(wanted, cut);
    const auto length = [&](const SeamSide& side) {
        const Tile& tile = cut.tiles[static_cast<std::size_t>(side.tile)];
        const Eigen::VectorXd cloth = target_lengths(tile), plain = drawn_lengths(tile);
        double sum = 0;
        for (const SeamPart& part : side.parts) sum += cloth[part.edge] * part.length / plain[part.edge];
        return sum;
    };
    for (const Seam& seam : cut.seams) EXPECT_NEAR(length(seam.a), length(seam.b), 1e-12 * seam.length) << seam.id;
}

TEST(Sensitivity, StifferClothComesNearerToTheDrawnShapeAndLooserTapesLetItRise) {
    const EnvelopeDesign design{.gores = 12, .panels = 4, .edge_length = 1};
    const std::vector<Sensitivity> all = measure_sensitivity(cut_balloon(design, false), {});
    const auto named = [&](const std::string& what) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.what == what; });
        EXPECT_NE(found, all.end()) << what;
        return found == all.end() ? Sensitivity{} : *found;
    };
    EXPECT_LT(named("cloth 20 % stiffer").off.moved_rms, named("cloth 20 % softer").off.moved_rms);
    for (const Sensitivity& each : all) EXPECT_EQ(each.what.find("tape"), std::string::npos);  // there are no tapes
}

}  // namespace compensate_test
}  // namespace ripstop
