#include "ripstop/report/words/check_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/checked_balloon.h"

namespace ripstop {
namespace check_report_test {

using ::testing::HasSubstr;
using namespace checked_balloon;

TEST(CheckText, SaysOnceWhatManyTilesHaveInCommon) {
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    const std::vector<NamedMesh> once = balloon;
    for (int k = 0; k < 12; ++k) {
        balloon.push_back({"stray" + std::to_string(k), testing::rectangle(0.5, 0.5, 4, 2), {}});
        move(balloon.back().mesh, Vec3(50, 0, 2 * k));
        balloon.push_back(once[static_cast<std::size_t>(k)]);
        balloon.back().name = "twice" + std::to_string(k);
    }
    const EnvelopeCheck result = check(balloon);
    EXPECT_EQ(result.issues.size(), 12u);
    const std::string text = check_text(result, "balloon.obj", "m");
    EXPECT_THAT(text, HasSubstr("tile twice0"));
    EXPECT_THAT(text, HasSubstr("; and 11 more like this"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("twice1 ")));
    EXPECT_THAT(text,
                HasSubstr("note           12 tiles (stray0, stray1, stray2, stray3, stray4, stray5 and 6 more) are "
                          "in 12 parts that are sewn to nothing else; "));
}

TEST(CheckText, GivesNumbersAsADesignerReadsThem) {
    // a gap of a third of a metre, one of a tenth of a nanometre, a tile 304.8 times too large; a small factor has
    // six decimals
    std::vector<NamedMesh> balloon = design_natural(small_balloon());
    for (NamedMesh& tile : balloon) move(tile.mesh, Vec3(1.0 / 3, -1e-10, 2.0 / 3));
    scale_about(balloon[middle].mesh, Vec3::Zero(), 304.8);
    balloon.push_back(strip("stray", 30.0 / 7, 40.0 / 7, 0.1));
    const std::string text = check_text(check(balloon), "balloon.obj", "m");
    EXPECT_THAT(text, HasSubstr("times too large"));
    EXPECT_THAT(text, HasSubstr("tile stray"));
    EXPECT_THAT(text, HasSubstr(" m round (0.33, 0.00, "));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("-0.00")));
    EXPECT_THAT(text, ::testing::Not(::testing::ContainsRegex("[0-9]\\.[0-9][0-9][0-9][0-9][0-9][0-9][0-9]")));
}

}  // namespace check_report_test
}  // namespace ripstop
