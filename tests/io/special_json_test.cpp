#include "ripstop/io/json/special_json.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "support/refusal.h"

namespace ripstop {
namespace special_json_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal(const std::string& text) {
    return testing::refusal([&] {
        std::istringstream in(text);
        read_special_shape(in, "shape.json");
    });
}

TEST(SpecialJson, JudgesTheCasesAsTheSchemaDoes) {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/tests/data/special_cases.json");
    const nlohmann::json cases = nlohmann::json::parse(in);
    EXPECT_GT(cases.size(), 20U);
    for (const auto& entry : cases) {
        SCOPED_TRACE(entry["what"].get<std::string>());
        const std::string said = refusal(entry["special"].dump());
        if (entry["sound"]) {
            EXPECT_EQ(said, "accepted");
        } else {
            EXPECT_THAT(said, StartsWith("shape.json: "));
            EXPECT_THAT(said, HasSubstr(entry["says"].get<std::string>()));
        }
    }
}

TEST(SpecialJson, RefusesWhatASchemaCannotSay) {
    const auto ball = [](const std::string& more, const std::string& edge = "250") {
        return R"({"edge_mm": )" + edge +
               R"(, "primitives": [{"name": "A", "type": "ellipsoid", "sectors": 6, "rings": 3,
            "radii_mm": [3000, 3000, 400])" +
               more + "}]}";
    };
    EXPECT_THAT(refusal(ball(R"(, "axis": [0, 0, 0])")), HasSubstr("primitive 1 (A): the axis has no direction"));
    EXPECT_THAT(refusal(ball("")),
                HasSubstr("the edge length of 250 mm is too coarse for it, expected at most 200 mm"));
    EXPECT_EQ(refusal(ball("", "200")), "accepted");
    EXPECT_THAT(refusal(R"({"edge_mm": 100, "edge_mm": 200, "primitives": []})"), HasSubstr("edge_mm"));
    EXPECT_THAT(refusal("{"), StartsWith("shape.json:1: not JSON"));
}

TEST(SpecialJson, ReadsTheExampleInTheDocs) {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/docs/special.example.json");
    const SpecialShape shape = read_special_shape(in, "example");
    EXPECT_DOUBLE_EQ(shape.edge_length, 0.06);
    EXPECT_DOUBLE_EQ(shape.mouth.value(), -2.35);
    EXPECT_EQ(shape.joint_radius, 0);
    ASSERT_EQ(shape.primitives.size(), 5U);
    EXPECT_EQ(shape.primitives[0].kind, PrimitiveKind::ellipsoid);
    EXPECT_LT((shape.primitives[0].radii - Vec3(2.3, 2.3, 2.7)).norm(), 1e-15);
    EXPECT_EQ(shape.primitives[2].name, "EAR-R");
    EXPECT_DOUBLE_EQ(shape.primitives[2].turn, 180 * degree);
    EXPECT_EQ(shape.primitives[2].axis, Vec3(-0.6, 0, 1));
    EXPECT_EQ(shape.primitives[4].kind, PrimitiveKind::torus);
    EXPECT_DOUBLE_EQ(shape.primitives[4].tube_radius, 0.4);
    EXPECT_EQ(shape.primitives[4].sectors, 20);
}

}  // namespace special_json_test
}  // namespace ripstop
