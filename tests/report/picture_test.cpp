#include "ripstop/report/picture/picture.h"

#include <gmock/gmock.h>

#include <limits>

#include "ripstop/report/figures/colour_scale.h"
#include "support/flat_tiles.h"
#include "support/outside.h"

namespace ripstop {
namespace picture_test {

using ::testing::HasSubstr;
using ::testing::Not;

int count(const std::string& text, const std::string& what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

TEST(ColourScale, IsPinnedToTheToleranceAndRedOnlyBeyondIt) {
    EXPECT_EQ(colour_class(0, 0.001), 0);
    EXPECT_EQ(colour_class(-0.0005, 0.001), 15);
    EXPECT_EQ(colour_class(0.001, 0.001), beyond_class - 1);
    EXPECT_EQ(colour_class(0.0010001, 0.001), beyond_class);
    EXPECT_EQ(colour_class(std::numeric_limits<double>::quiet_NaN(), 0.001), beyond_class);
    EXPECT_EQ(class_colour(0), "#2c5cc8");
    EXPECT_EQ(class_colour(beyond_class), "#ce1826");
    for (int c = 1; c < colour_classes; ++c) EXPECT_NE(class_colour(c), class_colour(c - 1)) << c;
}

TEST(TilePicture, OfATrueFlatteningHasOneColourAndNoRing) {
    const std::string svg = tile_picture(testing::flat_cylinder("G01P01"), {});
    EXPECT_EQ(count(svg, "stroke-linejoin=\"round\">\n<path fill=\"#2c5cc8\""), 1);
    EXPECT_EQ(count(svg, "z\"/>"), 1) << "all triangles in one path";
    EXPECT_EQ(count(svg, "r=\"11\""), 0);
    EXPECT_EQ(count(svg, ">0.000 %</text>"), 4) << "a figure a chain";
    EXPECT_THAT(svg, HasSubstr(">manufacturable</text>"));
}

TEST(TilePicture, DrawsTheTensionOfEachSeamEdgeWhereItIsKnown) {
    FlatTile tile = testing::flat_cylinder("G01P01");
    EXPECT_THAT(tile_picture(tile, {}), Not(HasSubstr("tension of the seams")));
    tile.flattening.seam_tension =
        Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(tile.tile.boundary.size()), -3, 12);
    const std::string svg = tile_picture(tile, {});
    EXPECT_THAT(svg, HasSubstr("-3.0 … 12.0 N"));
    const std::size_t pulled = svg.find("#5b8def"), pushed = svg.find("#e0a030");
    ASSERT_NE(pulled, std::string::npos);
    ASSERT_NE(pushed, std::string::npos);
    const auto strokes = [&](std::size_t from) { return count(svg.substr(from, svg.find("/>", from) - from), "L"); };
    EXPECT_EQ(strokes(pulled) + strokes(pushed), static_cast<int>(tile.tile.boundary.size()));
    EXPECT_GT(strokes(pulled), 3 * strokes(pushed));
}

TEST(TilePicture, NamesTheVerdictAndMarksTheFinding) {
    const CutPlan plan = testing::two_tile_plan();
    const std::string svg = tile_picture(plan.tiles[1], plan.tolerances);
    EXPECT_THAT(svg, HasSubstr("Bílý &quot;dráček&quot;"));
    EXPECT_THAT(svg, HasSubstr(">not manufacturable: chain</text>"));
    EXPECT_EQ(count(svg, "r=\"11\""), 2);
    EXPECT_LE(count(svg, "z\"/>"), colour_classes);
    EXPECT_LT(svg.size(), 100u * 564) << "bytes for 564 triangles";
}

TEST(TilePicture, IsPinnedToTheGivenLimitOfTheCloth) {
    const CutPlan plan = testing::two_tile_plan();
    const auto red_of = [](const std::string& svg) {
        const std::size_t at = svg.find("<path fill=\"#ce1826\"");
        return at == std::string::npos ? 0 : svg.find("\"/>", at) - at;
    };
    EXPECT_GT(red_of(tile_picture(plan.tiles[1], plan.tolerances, {0.001})),
              3 * red_of(tile_picture(plan.tiles[1], plan.tolerances)));
}

TEST(TilePicture, PaintsFlippedTrianglesBlack) {
    FlatTile tile = testing::flat_cylinder("G01P01");
    EXPECT_EQ(count(tile_picture(tile, {}), "fill=\"#000000\""), 0);
    tile.flattening.positions.row(40) = tile.flattening.positions.row(43);
    EXPECT_EQ(count(tile_picture(tile, {}), "fill=\"#000000\""), 1);
}

TEST(TilePicture, OfAFailedFlatteningSaysSo) {
    FlatTile tile = testing::flat_cylinder("G01P01");
    tile.flattening = {};
    tile.verdict = {};
    const std::string svg = tile_picture(tile, {});
    EXPECT_THAT(svg, HasSubstr("no flat positions: failed: not run"));
    EXPECT_THAT(svg, HasSubstr(">not judged</text>"));
}

TEST(TilePicture, IsWellFormedForARenderer) {
    if (testing::run_command("rsvg-convert --version").code != 0) GTEST_SKIP() << "no rsvg-convert here";
    const testing::ScratchDirectory scratch;
    const CutPlan plan = testing::two_tile_plan();
    testing::write_text(scratch.path("p.svg"), tile_picture(plan.tiles[1], plan.tolerances));
    const auto result = testing::run_command("rsvg-convert -o " + scratch.path("p.png") + " " + scratch.path("p.svg"));
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_GT(testing::content(scratch.path("p.png")).size(), 10000u);
}

}  // namespace picture_test
}  // namespace ripstop
