#include "ripstop/pipeline/read/seam_rules.h"

#include <gmock/gmock.h>

#include <map>
#include <sstream>

#include "ripstop/io/json/project_json.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/allowance.h"
#include "support/envelopes.h"

namespace ripstop {
namespace seam_rules_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Project project_of(const std::string& text) {
    std::istringstream in(text);
    return read_project(in, "plan.json");
}

/// Three gores of two panels: vertical seams between gores, horizontal ones between panels; mouth and crown are
/// open.
std::vector<NamedMesh> balloon() {
    return design_natural({.gores = 12, .panels = 2, .edge_length = 0.8});
}

Envelope sewn(const std::string& project) {
    ReadOptions options;
    options.project = project_of(project);
    return make_envelope(balloon(), options);
}

/// The seam types by their tiles, `G01P01 G01P02`.
std::map<std::string, SeamType> types(const Envelope& envelope) {
    std::map<std::string, SeamType> found;
    for (const Seam& seam : envelope.seams) {
        std::string a = envelope.tiles[static_cast<std::size_t>(seam.a.tile)].name;
        std::string b = envelope.tiles[static_cast<std::size_t>(seam.b.tile)].name;
        if (b < a) std::swap(a, b);
        found[a + " " + b] = seam.type;
    }
    return found;
}

int count(const Envelope& envelope, const std::string& type) {
    int sum = 0;
    for (const SeamTypeUse& use : seam_types_used(envelope))
        if (use.type.name == type) sum += use.seams + use.free_edges;
    return sum;
}

TEST(SeamRules, AreFlatFelledAndHemWhereNothingIsSaid) {
    const Envelope envelope = sewn("{}");
    EXPECT_EQ(envelope.seams.size(), 36U);
    EXPECT_EQ(count(envelope, "flat-felled"), 36);
    EXPECT_EQ(count(envelope, "hem"), 24);
}

TEST(SeamRules, FitEitherWayRoundAndTheLaterGoesBeforeTheEarlier) {
    const auto found = types(sewn(R"({"seams": [
        {"between": ["G02P01", "G01P01"], "type": "plain", "allowance_mm": 11},
        {"between": ["*", "*"], "type": "french"},
        {"between": ["G*P02", "G*P01"], "type": "overlap"}]})"));
    EXPECT_EQ(found.at("G01P01 G02P01"), (SeamType{"plain", 0.011, 1, false})) << "named in full goes first";
    EXPECT_EQ(found.at("G01P01 G01P02").name, "overlap");
    EXPECT_EQ(found.at("G02P01 G03P01").name, "french");
}

TEST(SeamRules, AllowanceAloneKeepsTheDefaultType) {
    const auto found = types(sewn(R"({"seams": [{"between": ["G01*", "G02*"], "allowance_mm": 30}]})"));
    EXPECT_EQ(found.at("G01P02 G02P02"), (SeamType{"flat-felled", 0.03, 2, false}));
    EXPECT_EQ(found.at("G02P02 G03P02"), SeamType{});
}

TEST(SeamRules, CutTheMatesEdgeAsWideAsItIsSaid) {
    const Envelope envelope = sewn(R"({"seams": [
        {"between": ["G01P02", "G01P01"], "allowance_mm": 12, "mate_allowance_mm": 30}]})");
    int found = 0;
    for (const Seam& seam : envelope.seams)
        for (const SeamSide* side : {&seam.a, &seam.b}) {
            const std::string& name = envelope.tiles[static_cast<std::size_t>(side->tile)].name;
            if (seam.type.allowance == SeamType{}.allowance) {
                EXPECT_EQ(seam.allowance(*side), SeamType{}.allowance);
                continue;
            }
            EXPECT_EQ(seam.allowance(*side), name == "G01P02" ? 0.012 : 0.030) << name;
            ++found;
        }
    EXPECT_EQ(found, 2);
}

TEST(SeamRules, TypesOfTheProjectTakeThePlaceOfTheDefaults) {
    const Envelope envelope = sewn(R"({"seam_types": [{"name": "flat-felled", "allowance_mm": 20},
        {"name": "hem", "allowance_mm": 50, "tape": true}, {"name": "glued", "allowance_mm": 10, "rows": 0}],
        "seams": [{"between": ["G01P01", "G01P02"], "type": "glued"}]})");
    const auto found = types(envelope);
    EXPECT_EQ(found.at("G01P01 G02P01"), (SeamType{"flat-felled", 0.02, 2, false}));
    EXPECT_EQ(found.at("G01P01 G01P02"), (SeamType{"glued", 0.01, 0, false}));
    EXPECT_EQ(envelope.tiles[0].chains[0].finish, (SeamType{"hem", 0.05, 2, true}));
}

TEST(SeamRules, TellAlongTheWarpFromAcross) {
    // rotating the warp by a quarter turn makes vertical seams run across it
    for (const bool turned : {false, true}) {
        const std::string warp = turned ? R"({"turn_deg": 90})" : R"({"turn_deg": 0})";
        const Envelope envelope = sewn(R"({"tiles": [{"name": "*", "warp": )" + warp + R"(}], "seams": [
            {"between": ["*", "*"], "direction": "along-warp", "type": "taped"},
            {"free": "*", "direction": "across-warp", "type": "mouth-hem"}]})");
        EXPECT_EQ(count(envelope, "taped"), turned ? 12 : 24) << "12 gores of two panels";
        EXPECT_EQ(count(envelope, "flat-felled"), turned ? 24 : 12);
        EXPECT_EQ(count(envelope, "mouth-hem"), turned ? 0 : 24);
    }
}

TEST(SeamRules, FinishFreeEdgesByTile) {
    const Envelope envelope = sewn(R"({"seams": [{"free": "G*P01", "type": "mouth-hem"},
                                                 {"free": "G03P01", "type": "raw"}]})");
    EXPECT_EQ(count(envelope, "mouth-hem"), 11);
    EXPECT_EQ(count(envelope, "raw"), 1);
    EXPECT_EQ(count(envelope, "hem"), 12);
}

TEST(UnusedEntries, AreNamedInTheOrderOfTheProject) {
    const Project project = project_of(R"({"materials": {"red": "nylon"}, "tiles": [{"name": "G*"}, {"name": "H*"}],
        "seams": [{"between": ["G01*", "G02*"], "type": "plain"}, {"between": ["G01*", "G07*"], "type": "plain"},
                  {"between": ["G01P01", "G01P02"], "direction": "along-warp", "type": "plain"},
                  {"free": "G01P01", "type": "hem"}, {"free": "H01", "type": "hem"}]})");
    ReadOptions options;
    options.project = project_of(R"({"tiles": [{"name": "*", "warp": {"direction": [0, 0, 1]}}]})");
    EXPECT_THAT(
        unused_entries(project, make_envelope(balloon(), options)),
        ElementsAre("plan.json: no tile is called \"H*\"", "plan.json: there is no seam between \"G01*\" and \"G07*\"",
                    "plan.json: there is no seam between \"G01P01\" and \"G01P02\" along the warp",
                    "plan.json: there is no free edge of \"H01\"", "plan.json: no tile is of the material \"red\""));
    EXPECT_THAT(unused_entries(project_of("{}"), make_envelope(balloon(), {})), IsEmpty());
}

}  // namespace seam_rules_test
}  // namespace ripstop
