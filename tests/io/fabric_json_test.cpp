#include "ripstop/io/json/fabric_json.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "support/refusal.h"

namespace ripstop {
namespace fabric_json_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Fabric read(const std::string& text) {
    std::istringstream in(text);
    return read_fabric(in, "mine.json");
}

std::string refusal(const std::string& text) {
    return testing::refusal([&] { read(text); });
}

/// A valid fabric with `more` at its end.
std::string fabric(const std::string& more) {
    return R"({"name": "mine", "warp_stiffness_n_per_m": 60000, "weft_stiffness_n_per_m": 50000,
               "shear_stiffness_n_per_m": 1500)" +
           more + "}";
}

TEST(FabricJson, ConvertsEachKeyFromItsUnit) {
    const Fabric cloth = read(fabric(R"(, "description": "d", "poisson_warp_weft": 0.2, "mass_kg_per_m2": 0.07,
                                          "roll_width_mm": 1524, "strain_limit_pct": 3, "shear_limit_deg": 90)"));
    EXPECT_EQ(cloth.name, "mine");
    EXPECT_EQ(cloth.description, "d");
    EXPECT_EQ(cloth.warp_stiffness, 60000);
    EXPECT_EQ(cloth.weft_stiffness, 50000);
    EXPECT_EQ(cloth.shear_stiffness, 1500);
    EXPECT_EQ(cloth.poisson, 0.2);
    EXPECT_EQ(cloth.mass, 0.07);
    EXPECT_DOUBLE_EQ(cloth.roll_width, 1.524);
    EXPECT_DOUBLE_EQ(cloth.strain_limit, 0.03);
    EXPECT_DOUBLE_EQ(cloth.shear_limit, 1.5707963267948966);
}

TEST(FabricJson, LeavesWhatIsAbsentAsInAFabric) {
    const Fabric cloth = read(fabric(""));
    EXPECT_EQ(cloth.mass, Fabric{}.mass);
    EXPECT_EQ(cloth.roll_width, Fabric{}.roll_width);
    EXPECT_EQ(cloth.poisson, 0);
}

TEST(FabricJson, IsReadAsItWasWritten) {
    for (const std::string& preset : fabric_presets()) {
        const std::string text = write_fabric(fabric_named(preset));
        EXPECT_EQ(write_fabric(read(text)), text);
        EXPECT_DOUBLE_EQ(read(text).shear_limit, fabric_named(preset).shear_limit);
    }
    EXPECT_THAT(write_fabric(fabric_named("nylon")), HasSubstr("\"shear_limit_deg\": 10.0\n"));
}

TEST(FabricJson, RefusesWhatItDoesNotKnow) {
    EXPECT_THAT(
        refusal(fabric(R"(, "mass": 65)")),
        StartsWith("mine.json: unknown key \"mass\", expected one of: name, description, warp_stiffness_n_per_m"));
    EXPECT_THAT(refusal(fabric(R"(, "mass_kg_per_m2": "65")")),
                HasSubstr("mass_kg_per_m2 is \"\"65\"\", expected a number"));
    EXPECT_THAT(refusal(fabric(R"(, "mass_kg_per_m2": null)")),
                HasSubstr("mass_kg_per_m2 is \"null\", expected a number"));
    EXPECT_THAT(refusal(fabric(R"(, "description": 1)")), HasSubstr("description is \"1\", expected a text"));
    EXPECT_THAT(refusal(fabric(R"(, "name": "again")")), HasSubstr("the key \"name\" occurs twice"));
    EXPECT_THAT(refusal(R"({"name": "mine"})"), HasSubstr("the key warp_stiffness_n_per_m is missing"));
    EXPECT_THAT(refusal(R"({"warp_stiffness_n_per_m": 1})"), HasSubstr("the key name is missing"));
}

TEST(FabricJson, RefusesWhatNoClothIs) {
    EXPECT_THAT(refusal(fabric(R"(, "mass_kg_per_m2": -1)")), HasSubstr("mine.json: the mass is -1"));
    EXPECT_THAT(refusal(fabric(R"(, "poisson_warp_weft": 1.2)")), HasSubstr("Poisson's ratio is 1.2"));
    EXPECT_THAT(refusal(fabric(R"(, "roll_width_mm": 0)")), HasSubstr("the roll width is 0"));
}

TEST(FabricJson, SaysInWhichLineATextIsNotJson) {
    EXPECT_THAT(refusal("{\"name\": \"a\",\n \"mass_kg_per_m2\": 0,065}"), StartsWith("mine.json:2: not JSON from"));
    EXPECT_THAT(refusal("{\n\n"), StartsWith("mine.json:3: not JSON from the end on"));
    EXPECT_THAT(refusal(""), StartsWith("mine.json:1: not JSON"));
    EXPECT_THAT(refusal("[1]"), HasSubstr("found \"[1]\", expected an object"));
    EXPECT_THAT(refusal(fabric(R"(, "mass_kg_per_m2": 1e999)")), HasSubstr("number is out of range"));
    EXPECT_THAT(refusal("{\"name\": \"\xFC\"}"), StartsWith("mine.json:1: not JSON"));
}

TEST(FabricJson, RefusesEndlessNestingBeforeItCostsTheStack) {
    std::string text(1000000, '[');
    text.append(1000000, ']');
    EXPECT_THAT(refusal(text), HasSubstr("more than 64 deep"));
}

TEST(FabricPresets, AreTheFourThatComeWithTheProgramAndValid) {
    EXPECT_THAT(fabric_presets(), ElementsAre("isotropic", "nylon", "nylon-silicone", "polyester"));
    for (const std::string& preset : fabric_presets()) {
        const Fabric cloth = fabric_named(preset);
        EXPECT_EQ(cloth.name, preset);
        EXPECT_THAT(cloth.description, HasSubstr("default")) << preset << " must say which numbers are measured";
    }
    EXPECT_EQ(fabric_named("isotropic").shear_stiffness, fabric_named("isotropic").warp_stiffness / 2);
}

// 1/E(a) = c^4/E1 + s^4/E2 + c^2 s^2 (1/G - 2 nu12/E1): the default nylon has 5742 N/m at 45 degrees.
TEST(FabricPresets, NylonIsTenTimesSofterOnTheBias) {
    const Fabric nylon = fabric_named("nylon");
    const double bias = 4 / (1 / nylon.warp_stiffness + 1 / nylon.weft_stiffness + 1 / nylon.shear_stiffness -
                             2 * nylon.poisson / nylon.warp_stiffness);
    EXPECT_NEAR(bias, 5742, 0.5);
}

TEST(FabricNamed, TakesAFileAndListsThePresetsForAnythingElse) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "ripstop_mine.json";
    std::ofstream(path) << fabric("");
    EXPECT_EQ(fabric_named(path.string()).name, "mine");
    const auto refused = [](const std::string& name) {
        try {
            fabric_named(name);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_THAT(refused("canvas"),
                StartsWith("no fabric \"canvas\"; known: isotropic, nylon, nylon-silicone, polyester"));
    EXPECT_THAT(refused("no/such.json"), StartsWith("no/such.json: the fabric file cannot be opened"));
}

}  // namespace fabric_json_test
}  // namespace ripstop
