#include "ripstop/pipeline/read/tile_fabrics.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/json/project_json.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "support/outside.h"
#include "support/sewn.h"
#include "support/shapes.h"

namespace ripstop {
namespace tile_fabrics_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::optional<Project> project_of(const std::string& text, const std::string& file = "plan.json") {
    std::istringstream in(text);
    return read_project(in, file);
}

Tile sheet(const std::string& name, const Attributes& attributes = {}) {
    TileOptions options;
    options.attributes = attributes;
    return make_tile(name, testing::rectangle(1, 1, 2, 2), options);
}

std::vector<std::string> fabrics(const Envelope& envelope) {
    std::vector<std::string> names;
    for (const Tile& tile : envelope.tiles) names.push_back(tile.fabric ? tile.fabric->name : "-");
    return names;
}

TEST(TileFabrics, ProjectGoesBeforeAttributeBeforeMaterial) {
    Envelope envelope{{sheet("a", {{"fabric", "polyester"}, {"material", "red"}}),
                       sheet("b", {{"fabric", "polyester"}, {"material", "red"}}), sheet("c", {{"material", "red"}}),
                       sheet("d", {{"material", "nylon"}}), sheet("e", {{"fabric", "cloth 7"}}), sheet("f")}};
    const auto project = project_of(R"({"materials": {"red": "nylon-silicone", "cloth 7": "polyester"},
                                        "tiles": [{"name": "*"}, {"name": "a", "fabric": "nylon"}]})");
    EXPECT_TRUE(give_fabrics(envelope, project, fabric_named("isotropic")).empty());
    EXPECT_THAT(fabrics(envelope), ElementsAre("nylon", "polyester", "nylon-silicone", "-", "polyester", "-"))
        << "a material is no fabric unless the project says which";
}

TEST(TileFabrics, OfTheEnvelopeAreNotTheTilesOwn) {
    Envelope envelope{{sheet("a", {{"fabric", "nylon"}}), sheet("b")}};
    give_fabrics(envelope, std::nullopt, fabric_named("nylon"));
    EXPECT_THAT(fabrics(envelope), ElementsAre("-", "-"));
}

TEST(TileFabrics, AreARemarkWhereTheFileNamesAnUnknownOne) {
    Envelope envelope{{sheet("a", {{"fabric", "silk"}}), sheet("b", {{"fabric", "silk"}}), sheet("c")}};
    EXPECT_THAT(
        give_fabrics(envelope, std::nullopt, fabric_named("nylon")),
        ElementsAre("tile a and 1 more should have the fabric \"silk\", which is unknown; nylon is used instead; "
                    "define it under \"materials\" in a project file"));
    EXPECT_THAT(fabrics(envelope), ElementsAre("-", "-", "-"));
}

TEST(TileFabrics, AreRefusedWhereTheProjectNamesAnUnknownOne) {
    const auto refusal = [](const std::string& text) -> std::string {
        Envelope envelope{{sheet("a")}};
        try {
            give_fabrics(envelope, project_of(text), {});
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(refusal(R"({"tiles": [{"name": "x*", "fabric": "silk"}]})"),
                HasSubstr("plan.json: tile \"x*\": fabric: no fabric \"silk\"; known: isotropic"));
    EXPECT_THAT(refusal(R"({"materials": {"red": "silk"}})"),
                HasSubstr("plan.json: materials: \"red\": no fabric \"silk\""));
    EXPECT_THROW(envelope_fabric("", project_of(R"({"fabric": "silk"})")), InputError);
}

TEST(TileFabrics, AreLookedForBesideTheProject) {
    const testing::ScratchDirectory scratch;
    Fabric silk = fabric_named("nylon");
    silk.name = "silk";
    testing::write_text(scratch.path("silk.json"), write_fabric(silk));
    const auto project = project_of(R"({"fabric": "silk.json", "tiles": [{"name": "a", "fabric": "silk.json"}]})",
                                    scratch.path("p.json"));
    EXPECT_EQ(envelope_fabric("", project).name, "silk");
    EXPECT_EQ(envelope_fabric("polyester", project).name, "polyester");
    Envelope envelope{{sheet("a"), sheet("b")}};
    give_fabrics(envelope, project, fabric_named("isotropic"));
    EXPECT_THAT(fabrics(envelope), ElementsAre("silk", "-"));
}

/// Two gores of the sphere sewn together, the second of another cloth.
Envelope two_cloths(const std::string& second) {
    Envelope envelope = testing::gores({0.3}, 2, 4, 10);
    envelope.tiles[1].fabric = fabric_named(second);
    return envelope;
}

TEST(FlattenEnvelope, FlattensAndJudgesEachTileInItsOwnFabric) {
    const Fabric nylon = fabric_named("nylon");
    Fabric soft = fabric_named("polyester");
    soft.shear_stiffness /= 20;
    soft.strain_limit = 1e-6;
    Envelope envelope = two_cloths("nylon");
    envelope.tiles[1].fabric = soft;
    const CutPlan plan = flatten_envelope(envelope, {.fabric = nylon});
    for (std::size_t i = 0; i < 2; ++i) {
        Envelope alone{{envelope.tiles[i]}};
        alone.tiles[0].fabric.reset();
        const CutPlan own = flatten_envelope(alone, {.fabric = i == 0 ? nylon : soft});
        EXPECT_EQ(plan.tiles[i].flattening.positions, own.tiles[0].flattening.positions) << i;
        EXPECT_EQ(plan.tiles[i].accuracy.energy, own.tiles[0].accuracy.energy) << i;
    }
    EXPECT_NE(plan.tiles[0].accuracy.energy, plan.tiles[1].accuracy.energy);
    const auto strained = [&](const CutPlan& judged, std::size_t i) {
        for (const Finding& finding : judged.tiles[i].verdict.findings)
            if (finding.code == "warp_strain" || finding.code == "weft_strain") return true;
        return false;
    };
    EXPECT_FALSE(strained(plan, 0));
    EXPECT_TRUE(strained(plan, 1)) << "its own fabric stands no strain";
    const CutPlan told = flatten_envelope(envelope, {.fabric = nylon, .tolerances = {.strain_for_all = true}});
    EXPECT_FALSE(strained(told, 1)) << "a strain that is given holds for every fabric";
    EXPECT_EQ(plan.fabrics().size(), 2U);
}

TEST(FlattenEnvelope, CutsNoTwoFabricsByOnePattern) {
    const FlattenOptions nylon{.fabric = fabric_named("nylon")};
    EXPECT_EQ(flatten_envelope(testing::gores({0.3}, 2, 4, 10), nylon).tiles[1].equal_to, 0);
    EXPECT_EQ(flatten_envelope(two_cloths("polyester"), nylon).tiles[1].equal_to, -1);
}

TEST(FlattenEnvelope, CutsNoTwoAllowancesByOnePattern) {
    Envelope envelope{{sheet("a"), sheet("b"), sheet("c")}};
    for (Tile& tile : envelope.tiles) tile.chains[1].finish.allowance = 0.05;
    const CutPlan alike = flatten_envelope(envelope, {});
    EXPECT_EQ(alike.tiles[1].equal_to, 0);
    envelope.tiles[1].chains[2].finish.allowance = 0.05;
    const CutPlan plan = flatten_envelope(envelope, {});
    EXPECT_EQ(plan.tiles[1].equal_to, -1);
    EXPECT_EQ(plan.tiles[2].equal_to, 0);
}

TEST(SeamMatched, HasTheSameEnergyAsATileOfItsOwnFabricHas) {
    // The same cloth, stated once for the envelope and once for each tile, gives the same problem.
    Envelope whole = testing::gores({0.3, 0.2}, 4, 4, 10), own = whole;
    const Fabric nylon = fabric_named("nylon"), polyester = fabric_named("polyester");
    for (Tile& tile : own.tiles) tile.fabric = nylon;
    const auto positions = [](const Envelope& envelope, const Fabric& fabric) {
        return flatten_envelope(envelope, {.method = "seam-matched", .fabric = fabric}).tiles[1].flattening.positions;
    };
    EXPECT_EQ(positions(whole, nylon), positions(own, polyester));
    EXPECT_NE(positions(whole, polyester), positions(own, polyester));
}

}  // namespace tile_fabrics_test
}  // namespace ripstop
