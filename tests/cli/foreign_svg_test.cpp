/// `ripstop validate` on SVG files from other programs, each of which was once misread.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "support/program.h"
#include "support/shared_data.h"

namespace ripstop {
namespace foreign_svg_test {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;

nlohmann::json validated(const std::filesystem::path& file, int code) {
    const Workshop workshop;
    const ProgramRun run = workshop.ripstop("validate --json " + file.string());
    EXPECT_EQ(run.code, code) << run.out << run.err;
    return nlohmann::json::parse(run.out, nullptr, false);
}

/// The width and the height of a contour.
std::vector<double> size_of(const nlohmann::json& contour) {
    const auto corner = [&contour](const char* key, int k) { return contour.at(key).at(k).get<double>(); };
    return {corner("upper_mm", 0) - corner("lower_mm", 0), corner("upper_mm", 1) - corner("lower_mm", 1)};
}

void expect_size(const nlohmann::json& check, double width, double height) {
    ASSERT_EQ(check.at("contours").size(), 1U);
    const std::vector<double> size = size_of(check.at("contours").at(0));
    EXPECT_NEAR(size[0], width, 1e-3);
    EXPECT_NEAR(size[1], height, 1e-3);
}

TEST(ForeignSvg, ARectangleInMillimetresHasThem) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/svg_rect_in_mm.svg");
    expect_size(validated(file, 0), 100, 100);
}

TEST(ForeignSvg, ARectangleInPerCentIsAPartOfItsPage) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/svg_rect_percent.svg");
    expect_size(validated(file, 0), 105, 148.5);
}

TEST(ForeignSvg, FlagsOfArcsNeedNothingBetweenThem) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/svg_compressed_arc_flags.svg");
    const auto check = validated(file, 0);
    expect_size(check, 100, 102);
    // 100 x 100, plus the strip of 2 below, whose corners are quarter circles.
    const double area = 100 * 100 + 96 * 2 + std::numbers::pi * 2;
    EXPECT_NEAR(check.at("contours").at(0).at("area_m2").get<double>() * 1e6, area, 0.1);
}

TEST(ForeignSvg, ACircleOfBezierCurvesIsAsLargeAsACircle) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/svg_bezier_16_chords.svg");
    const auto check = validated(file, 0);
    expect_size(check, 2000, 2000);
    // Four cubics with control points at distance k from their ends enclose 2 + 12 k / 5 - 3 k^2 / 5, by the
    // integral of x dy. Chords within 0.05 mm lose at most 0.05 mm times the perimeter.
    constexpr double k = 0.552285, area = 2 + 2.4 * k - 0.6 * k * k;
    EXPECT_NEAR(check.at("contours").at(0).at("area_m2").get<double>(), area, 0.05e-3 * 2 * std::numbers::pi);
    EXPECT_NEAR(check.at("contours").at(0).at("perimeter_mm").get<double>(), 2000 * std::numbers::pi, 1);
}

TEST(ForeignSvg, LettersOfAnySizeAreNoReasonToRefuse) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/svg_font_size_em.svg");
    expect_size(validated(file, 0), 100, 100);
}

TEST(ForeignSvg, OldInkscapeIsMeasuredInItsPixelsAndTheConflictIsSaid) {
    RIPSTOP_REQUIRE_SHARED(file, "faults/files/svg_inkscape_091_90dpi.svg");
    const auto check = validated(file, 1);
    expect_size(check, 100, 100);
    EXPECT_EQ(check.at("unit_from"), "Inkscape 0.91 (90 px to the inch)");
    ASSERT_FALSE(check.at("issues").empty());
    EXPECT_EQ(check.at("issues").at(0).at("code"), "unit_conflict");
}

TEST(ForeignSvg, AnOpenOutlineIsNeverSound) {
    for (const char* name : {"svg_open_outline", "svg_use_unchecked"}) {
        RIPSTOP_REQUIRE_SHARED(file, (std::string("faults/files/") + name + ".svg"));
        const auto check = validated(file, 1);
        EXPECT_EQ(check.at("contours").size(), 1U) << name;
        const auto& code = check.at("issues").at(0).at("code");
        EXPECT_TRUE(code == "gap" || code == "open") << name << ": " << code;
    }
}

}  // namespace foreign_svg_test
}  // namespace ripstop
