/// What the default method adds on the command line.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/program.h"
#include "support/shapes.h"

namespace ripstop {
namespace seam_exact_test {

using ::testing::HasSubstr;

TEST(SeamExactCommand, IsTheDefaultAndShowsItsCertificateAndTension) {
    const testing::Workshop shop;
    shop.write_tiles("tile.obj", {{"square", testing::spherical_square(0.1, 8), {}}});
    EXPECT_EQ(shop.ripstop("flatten tile.obj -o plan").code, 0);
    const std::string report = shop.read("plan/report.json");
    EXPECT_THAT(report, HasSubstr("\"method\": \"seam-exact\""));
    EXPECT_THAT(report, HasSubstr("\"strict_minimum\": true"));
    EXPECT_THAT(report, HasSubstr("\"tension_n\""));
    EXPECT_THAT(report, HasSubstr("\"stretch_ratio_min\""));
}

TEST(SeamExactCommand, HoldsTheAreaWhereAsked) {
    const testing::Workshop shop;
    shop.write_tiles("tile.obj", {{"gore", testing::lune(0.4, 6, 24), {}}});
    shop.ripstop("flatten tile.obj --keep-area -o plan");
    EXPECT_THAT(shop.read("plan/report.json"), HasSubstr("\"method\": \"seam-exact-area\""));
    const auto report = nlohmann::json::parse(shop.read("plan/report.json"));
    EXPECT_NEAR(report["tiles"][0]["area_error_pct"].get<double>(), 0, 1e-9);  // lengths are kept to 1e-11
    EXPECT_EQ(shop.ripstop("flatten tile.obj --keep-area --method paper -o other").code, 2);
}

TEST(SeamExactCommand, CutsLongerByTheCompensationOfTheProject) {
    const testing::Workshop shop;
    shop.write_tiles("sheet.obj", {{"sheet", testing::rectangle(2, 1, 8, 4), {}}});
    shop.write("shop.json", R"({"unit": "m", "tiles": [{"name": "sh*",
        "warp": {"from": [0, 0, 0], "to": [0, 0.5, 0]}, "compensation": {"warp_pct": 1}}]})");
    const testing::ProgramRun run = shop.ripstop("flatten sheet.obj --project shop.json -o plan");
    EXPECT_EQ(run.code, 0) << run.err;
    // the warp runs along the short side, which is cut one per cent longer: 2 x 1.01 m²
    EXPECT_THAT(shop.read("plan/report.json"), HasSubstr("\"flat_area_m2\": 2.02"));
}

TEST(SeamExactCommand, NamesTheReasonWhereNoOutlineHoldsTheArea) {
    const testing::Workshop shop;
    shop.write_tiles("cap.obj", {{"cap", testing::cap(0.8, 6), {}}});
    EXPECT_EQ(shop.ripstop("flatten cap.obj -o plan").code, 1);
    EXPECT_THAT(shop.read("plan/report.json"), HasSubstr("\"code\": \"isoperimetric\""));
}

}  // namespace seam_exact_test
}  // namespace ripstop
