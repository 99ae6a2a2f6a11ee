/// Whole envelopes: seams found, tiles flattened, seams walked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "ripstop/measure/judge.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/envelopes.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {
namespace sewn_envelope_test {

CutPlan flatten(const Envelope& envelope, const std::string& method = "seam-exact") {
    return flatten_envelope(envelope, {.method = method});
}

/// Certified edges are exact to 1e-8 of their length; 0.01 mm per metre is required.
void expect_exact_seams(const CutPlan& plan) {
    ASSERT_EQ(plan.walks.size(), plan.seams.size());
    for (std::size_t i = 0; i < plan.walks.size(); ++i) {
        EXPECT_LT(plan.walks[i].drift_max, 2e-8 * plan.walks[i].length) << plan.seams[i].id;
        EXPECT_TRUE(plan.walks[i].ok);
    }
}

void expect_exact_and_certain_seams(const CutPlan& plan) {
    expect_exact_seams(plan);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(SewnEnvelope, MeshedTileByTileHasExactSeams) {
    const EnvelopeDesign design{.gores = 10, .panels = 5, .volume = 600, .edge_length = 0.4};
    const CutPlan plan = flatten(make_envelope(testing::meshed_apart(design, 5), {}));
    EXPECT_EQ(static_cast<int>(plan.seams.size()), testing::seam_count(design));
    expect_exact_and_certain_seams(plan);
}

TEST(SewnEnvelope, WithTJunctionsHasExactSeams) {
    const int rows = 4, bricks = 10;
    const CutPlan plan = flatten(make_envelope(testing::brick_wall(rows, bricks), {}));
    EXPECT_EQ(static_cast<int>(plan.seams.size()), rows * bricks + (rows - 1) * 2 * bricks);
    expect_exact_and_certain_seams(plan);
}

TEST(SewnEnvelope, OfBentSheetsMeshedDifferentlyFitsByMethodsThatKnowOnlyTheMesh) {
    TriangleMesh upper = testing::cylinder(1, 1, 0.6, 14, 5);
    upper.positions.col(2).array() += 0.5;
    const Envelope envelope =
        make_envelope({{"lower", testing::cylinder(1, 1, 0.5, 9, 4), {}}, {"upper", upper, {}}}, {});
    ASSERT_EQ(envelope.seams.size(), 1u);
    for (const char* method : {"lscm", "arap", "seam-exact"}) {
        const SeamWalk walk = flatten(envelope, method).walks.front();
        // The two polylines differ by (1/9^2 - 1/14^2) / 24 of a radian; the rest is the uncertainty of the arc.
        const double polylines = (1.0 / 81 - 1.0 / 196) / 24;
        EXPECT_LT(walk.drift_max, std::max(1e-6, 1e-3 * polylines)) << method;
        EXPECT_NEAR(walk.length, 1, 1e-4);
        EXPECT_TRUE(walk.ok);
    }
}

TEST(RealInput, TheDressHasExactSeamsAndItsOwnPatternTheMismatchThatWasPublished) {
    RIPSTOP_REQUIRE_SHARED(dress, "dress/dress_knife_drape_3d.obj");
    RIPSTOP_REQUIRE_SHARED(list, "dress/dress_knife_seams.json");
    const Envelope envelope = read_envelope(dress, {});
    const CutPlan plan = flatten(envelope);
    expect_exact_seams(plan);
    // Cloth drapes in folds that its triangles hardly follow, so the length of many seams is uncertain. Each of
    // these is a finding, and there are no others.
    std::vector<const SeamWalk*> open;
    for (const SeamWalk& walk : plan.walks)
        if (walk.uncertainty > 0.001 * walk.length) open.push_back(&walk);
    ASSERT_EQ(plan.findings.size(), open.size());
    for (std::size_t i = 0; i < open.size(); ++i) {
        EXPECT_EQ(plan.findings[i].code, "uncertain");
        EXPECT_DOUBLE_EQ(plan.findings[i].value, open[i]->uncertainty / millimetre);
        EXPECT_DOUBLE_EQ(plan.findings[i].limit, open[i]->length);  // 0.1 %, in mm
    }
    const CutPlan given = flatten(envelope, "given");
    std::ifstream in(list);
    const nlohmann::json published = nlohmann::json::parse(in);
    int certain = 0;
    // A seam of the list matches one of ours if they join the same panels and their lengths agree to 1 %; short
    // ones are skipped.
    std::vector<double> differences;
    for (const auto& seam : published["seams"]) {
        if (seam["panel_a"].size() != 1 || seam["panel_b"].size() != 1 || seam["panel_a"] == seam["panel_b"]) continue;
        const int a = seam["panel_a"][0], b = seam["panel_b"][0];
        const double length = seam["draped_len_a"];
        if (length < 0.06) continue;
        for (std::size_t i = 0; i < given.seams.size(); ++i) {
            const Seam& ours = given.seams[i];
            const bool turned = ours.a.tile == b && ours.b.tile == a;
            if (!turned && !(ours.a.tile == a && ours.b.tile == b)) continue;
            if (std::abs(ours.length / length - 1) > 0.01) continue;
            // If the list's two sides have different draped lengths, our seam is uncertain.
            const double apart = std::abs(seam["draped_len_a"].get<double>() - seam["draped_len_b"].get<double>());
            if (plan.walks[i].is_certain()) {
                EXPECT_LE(apart, plan.walks[i].limit) << ours.id;
                ++certain;
            }
            const double mismatch = (turned ? -1 : 1) * given.walks[i].mismatch();
            const double reference = seam["flat_len_b"].get<double>() - seam["flat_len_a"].get<double>();
            differences.push_back(std::abs(mismatch - reference));
        }
    }
    ASSERT_GE(differences.size(), 15u);
    EXPECT_GE(certain, 12);
    std::sort(differences.begin(), differences.end());
    EXPECT_LT(differences[differences.size() / 2], 0.0001) << "a tenth of a millimetre, of mismatches up to 34 mm";
    EXPECT_LT(differences.back(), 0.001);
}

}  // namespace sewn_envelope_test
}  // namespace ripstop
