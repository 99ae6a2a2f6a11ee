#include "ripstop/io/json/sewing_json.h"

#include <gmock/gmock.h>

#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "support/refusal.h"
#include "support/sewn.h"

namespace ripstop {
namespace sewing_json_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

CutPlan sphere_plan() {
    Envelope envelope = testing::gores({0.5}, 3, 4, 8);
    envelope.tiles[1].compensation = {0.01, 0.02, {0.003}};
    envelope.tiles[2].grain.field = Points3::Constant(envelope.tiles[2].mesh.triangle_count(), 3, 0.1);
    envelope.seams[0].type.tape = true;
    envelope.seams[0].b.allowance = 0.012345678901234567;
    CutPlan plan = flatten_envelope(envelope, {"lscm"});
    plan.tape_factors.assign(plan.seams.size(), 0.99);
    return plan;
}

Sewing read(const std::string& text) {
    std::istringstream in(text);
    return read_sewing(in, "sewing.json");
}

std::string refusal(const std::string& text) {
    return testing::refusal([&] { read(text); });
}

TEST(SewingJson, ReadsBackWhatItWroteToTheSameDoubles) {
    const CutPlan plan = sphere_plan();
    const Sewing sewing = read(sewing_json(plan, {"a", "b", "c"}));
    EXPECT_THAT(sewing.files, ElementsAre("a", "b", "c"));
    ASSERT_EQ(sewing.plan.seams.size(), plan.seams.size());
    for (std::size_t s = 0; s < plan.seams.size(); ++s) {
        const Seam &there = sewing.plan.seams[s], &here = plan.seams[s];
        EXPECT_EQ(there.id, here.id);
        EXPECT_EQ(there.length, here.length);
        EXPECT_EQ(there.type, here.type);
        EXPECT_EQ(there.b.allowance, here.b.allowance);
        ASSERT_EQ(there.a.parts.size(), here.a.parts.size());
        for (std::size_t i = 0; i < here.a.parts.size(); ++i) {
            EXPECT_EQ(there.a.parts[i].edge, here.a.parts[i].edge);
            EXPECT_EQ(there.a.parts[i].length, here.a.parts[i].length);
        }
    }
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Tile &there = sewing.plan.tiles[i].tile, &here = plan.tiles[i].tile;
        EXPECT_EQ(there.name, here.name);
        EXPECT_EQ(there.fabric_or({}).name, plan.fabric_of(here).name);
        EXPECT_EQ(there.fabric_or({}).warp_stiffness, plan.fabric_of(here).warp_stiffness);
        EXPECT_EQ(there.grain.direction, here.grain.direction);
        EXPECT_EQ(there.grain.field, here.grain.field);
        EXPECT_EQ(there.compensation.warp, here.compensation.warp);
        EXPECT_EQ(there.compensation.chains, here.compensation.chains);
        EXPECT_EQ(there.curve_lengths, here.curve_lengths);
        ASSERT_EQ(there.chains.size(), here.chains.size());
        EXPECT_EQ(sewing.corners[i][0], here.chains[0].vertices.front());
    }
    EXPECT_EQ(sewing.plan.tape_factors, plan.tape_factors);
    EXPECT_FALSE(sewing.plan.is_compensated);
}

TEST(SewingJson, KnowsAPlanThatWasCutForItsFlight) {
    CutPlan plan = sphere_plan();
    plan.tiles[0].tile.compensation.strain = Points3::Zero(plan.tiles[0].tile.mesh.triangle_count(), 3);
    EXPECT_TRUE(read(sewing_json(plan, {"a", "b", "c"})).plan.is_compensated);
}

TEST(SewingJson, RefusesAnythingElseAndSaysWhere) {
    const std::string whole = sewing_json(sphere_plan(), {"a", "b", "c"});
    const auto without = [&](const std::string& what, const std::string& instead) {
        std::string text = whole;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), instead);
    };
    EXPECT_THAT(refusal("[]"), HasSubstr("sewing.json"));
    EXPECT_THAT(refusal("{\"schema\": \"1.1\"}"), HasSubstr("input is missing"));
    EXPECT_THAT(refusal(without("\"schema\":\"1.1\"", "\"schema\":\"9\"")), HasSubstr("a different version"));
    EXPECT_THAT(refusal(without("\"tile\":", "\"tile\":99,\"x\":")), HasSubstr("tile is out of range"));
    EXPECT_THAT(refusal(without("\"edges\":[", "\"edges\":[1,")), HasSubstr("differ in number"));
    EXPECT_THAT(refusal(without("\"edges\":[", "\"edges\":[-1,")), HasSubstr("edges is out of range"));
    EXPECT_THAT(refusal(without("\"tape_factors\":[", "\"tape_factors\":[1,")),
                HasSubstr("differ in number from the seams"));
    EXPECT_THAT(refusal(whole.substr(0, whole.size() / 2)), HasSubstr("sewing.json"));
}

}  // namespace sewing_json_test
}  // namespace ripstop
