#include "ripstop/io/text/png.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "support/raster.h"

namespace ripstop {
namespace png_test {

using ::testing::ElementsAre;

std::string drawing(const std::string& content) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"20.5\" font-family=\"DejaVu Sans\">" +
           content + "</svg>";
}

int count_dark(const testing::Raster& raster) {
    int count = 0;
    for (std::size_t i = 0; i < raster.rgb.size(); i += 3) count += raster.rgb[i] < 128;
    return count;
}

TEST(PngPicture, IsAsLargeAsItsDrawingAndWhiteWhereNothingIsDrawn) {
    const testing::Raster raster =
        testing::read_png(png_picture(drawing("<rect x=\"10\" y=\"5\" width=\"4\" height=\"2\" fill=\"#2040a0\"/>")));
    ASSERT_EQ(raster.width, 40);
    ASSERT_EQ(raster.height, 21);
    for (int y = 0; y < raster.height; ++y)
        for (int x = 0; x < raster.width; ++x) {
            const bool is_drawn = x >= 10 && x < 14 && y >= 5 && y < 7;
            EXPECT_EQ(raster.at(x, y), is_drawn ? (std::array{0x20, 0x40, 0xa0}) : (std::array{255, 255, 255}))
                << x << ", " << y;
        }
}

TEST(PngPicture, AveragesPixelsThatAreFinerThanThePageAndDrawsOverThem) {
    Pixels fine{8, 4, std::vector<std::uint32_t>(32, 0x000000)};
    for (std::size_t i = 0; i < 32; i += 2) fine.colours[i] = 0xff0000;
    const testing::Raster raster = testing::read_png(png_picture(
        drawing("<rect x=\"22\" y=\"10\" width=\"2\" height=\"2\" fill=\"#00ff00\"/>"), {{fine, {20, 10}, 2}}));
    EXPECT_NEAR(raster.at(21, 10)[0], 128, 2) << "half red, half black; away from the pixels' border";
    EXPECT_THAT(raster.at(23, 10), ElementsAre(0, 255, 0));
    EXPECT_THAT(raster.at(30, 10), ElementsAre(255, 255, 255));
}

TEST(PngPicture, WritesNamesInOtherScripts) {
    const auto ink = [](const std::string& text) {
        const std::string svg = drawing("<text x=\"2\" y=\"16\" font-size=\"16\">" + text + "</text>");
        return count_dark(testing::read_png(png_picture(svg)));
    };
    EXPECT_GT(ink("Šař"), 10);
    EXPECT_GT(ink("Шар"), 10);
}

TEST(PngPicture, HasTheSameBytesEachTime) {
    const std::string svg = drawing("<text x=\"2\" y=\"16\" font-size=\"12\">G01</text>");
    EXPECT_EQ(png_picture(svg), png_picture(svg));
}

TEST(PngPicture, TakesDrawingsOfManyMegabytes) {
    std::string path = "M0 0";
    while (path.size() < 11'000'000) path += "L1 1";
    EXPECT_EQ(testing::read_png(png_picture(drawing("<path fill=\"none\" d=\"" + path + "\"/>"))).width, 40);
}

TEST(PngPicture, OfWhatIsNoDrawingIsOurFault) {
    EXPECT_THROW(png_picture("<svg"), std::runtime_error);
}

}  // namespace png_test
}  // namespace ripstop
