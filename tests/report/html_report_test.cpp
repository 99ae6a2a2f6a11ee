#include "ripstop/report/page/html_report.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/strain_maps.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/page/page_shapes.h"
#include "ripstop/report/page/page_template.h"
#include "ripstop/tile/targets.h"
#include "support/flat_tiles.h"
#include "support/inflated.h"

namespace ripstop {
namespace html_report_test {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// An independent decoder of `page_shapes`: its text and arrays.
struct Shapes {
    json text;
    std::string arrays;

    explicit Shapes(const std::string& bytes) {
        EXPECT_EQ(bytes.substr(0, 4), "RSP1");
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k)
            length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[4 + k])) << (8 * k);
        text = json::parse(bytes.substr(8, length));
        arrays = bytes.substr(8 + length);
    }

    template <class Number>
    std::vector<Number> numbers(int array) const {
        const std::size_t start = text["arrays"][static_cast<std::size_t>(array)][0],
                          length = text["arrays"][static_cast<std::size_t>(array)][1];
        std::vector<Number> values(length / sizeof(Number));
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < sizeof(Number); ++k)
                value |= static_cast<std::uint32_t>(static_cast<unsigned char>(arrays[start + i * sizeof(Number) + k]))
                         << (8 * k);
            values[i] = static_cast<Number>(value);
        }
        return values;
    }

    template <class Number>
    std::vector<Number> summed(int array, std::size_t columns) const {
        std::vector<Number> values = numbers<Number>(array);
        for (std::size_t i = columns; i < values.size(); ++i)
            values[i] = static_cast<Number>(values[i] + values[i - columns]);
        return values;
    }

    std::vector<double> map(const json& map) const {
        std::vector<double> values;
        for (const std::int16_t value : numbers<std::int16_t>(map["array"]))
            values.push_back(value == -32768 ? std::nan("") : value * map["step"].get<double>());
        return values;
    }
};

CutPlan plan_with_names(const std::string& first, const std::string& file) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].tile.name = first;
    plan.input_file = file;
    return plan;
}

std::string page(const CutPlan& plan) {
    return html_report(plan, make_pieces(plan), measure_strain_maps(plan), report_json(plan, true));
}

std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const std::size_t from = text.find(before);
    EXPECT_NE(from, std::string::npos) << before;
    if (from == std::string::npos) return {};
    const std::size_t start = from + before.size();
    return text.substr(start, text.find(after, start) - start);
}

std::string decoded(const std::string& text) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned group = 0;
    int bits = 0;
    for (const char letter : text) {
        if (letter == '=') break;
        group = (group << 6) | static_cast<unsigned>(letters.find(letter));
        if ((bits += 6) >= 8) bytes += static_cast<char>((group >> (bits -= 8)) & 0xff);
    }
    return bytes;
}

std::string inflated(const std::string& packed) {
    std::string text(50'000'000, '\0');
    uLongf size = static_cast<uLongf>(text.size());
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                         static_cast<uLong>(packed.size())),
              Z_OK);
    text.resize(size);
    return text;
}

TEST(Base64, IsThatOfTheStandard) {  // RFC 4648, section 10
    const std::string text = "foobar";
    const char* expected[] = {"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (std::size_t i = 0; i <= text.size(); ++i) EXPECT_EQ(base64(text.substr(0, i)), expected[i]);
    EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}

TEST(PageShapes, HoldPositionsTrianglesAndMapsOfEveryTile) {
    const CutPlan plan = testing::two_tile_plan();
    const std::vector<StrainMap> strains = measure_strain_maps(plan);
    const Shapes shapes(page_shapes(plan, make_pieces(plan), strains));
    ASSERT_EQ(shapes.text["tiles"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const FlatTile& tile = plan.tiles[i];
        const json& said = shapes.text["tiles"][i];
        const auto space = shapes.summed<std::uint16_t>(said["space"]["array"], 3);
        const auto flat = shapes.summed<std::uint16_t>(said["flat"]["array"], 2);
        const auto corners = shapes.summed<std::uint16_t>(said["triangles"], 3);
        const auto loop = shapes.summed<std::uint16_t>(said["loop"], 1);
        ASSERT_EQ(space.size(), static_cast<std::size_t>(3 * tile.tile.mesh.vertex_count()));
        ASSERT_EQ(corners.size(), static_cast<std::size_t>(3 * tile.tile.mesh.triangle_count()));
        const double step = said["space"]["step_m"], flat_step = said["flat"]["step_m"];
        for (int v = 0; v < tile.tile.mesh.vertex_count(); ++v) {
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(said["space"]["lower_m"][static_cast<std::size_t>(k)].get<double>() +
                                step * space[static_cast<std::size_t>(3 * v + k)],
                            tile.tile.mesh.positions(v, k), 0.51 * step);
            for (int k = 0; k < 2; ++k)
                EXPECT_NEAR(said["flat"]["lower_m"][static_cast<std::size_t>(k)].get<double>() +
                                flat_step * flat[static_cast<std::size_t>(2 * v + k)],
                            tile.flattening.positions(v, k), 0.51 * flat_step);
        }
        for (int t = 0; t < tile.tile.mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k)
                EXPECT_EQ(corners[static_cast<std::size_t>(3 * t + k)], tile.tile.mesh.triangles(t, k));
        EXPECT_EQ(std::vector<int>(loop.begin(), loop.end()), tile.tile.boundary);
        const std::vector<double> shear = shapes.map(said["maps"]["shear"]);
        for (std::size_t t = 0; t < shear.size(); ++t)
            EXPECT_NEAR(shear[t], strains[i].shear[static_cast<Eigen::Index>(t)],
                        said["maps"]["shear"]["step"].get<double>());
    }
}

TEST(PageShapes, HoldThePiecesInHundredthsOfAMillimetre) {
    const CutPlan plan = testing::two_tile_plan();
    const std::vector<PatternPiece> pieces = make_pieces(plan);
    const Shapes shapes(page_shapes(plan, pieces, {}));
    ASSERT_EQ(shapes.text["pieces"].size(), pieces.size());
    const auto cut = shapes.summed<std::int32_t>(shapes.text["pieces"][1]["cut"], 2);
    ASSERT_EQ(cut.size(), static_cast<std::size_t>(2 * pieces[1].cut_line.rows()));
    for (std::size_t i = 0; i < cut.size(); ++i)
        EXPECT_NEAR(cut[i] * 1e-5,
                    pieces[1].cut_line(static_cast<Eigen::Index>(i / 2), static_cast<Eigen::Index>(i % 2)), 0.51e-5);
    EXPECT_EQ(shapes.text["pieces"][1]["tile"], 1);
    EXPECT_FALSE(shapes.text["tiles"][0]["maps"].contains("warp")) << "no strains were given";
}

TEST(PageShapes, ShareWhatEqualTilesHaveAlike) {
    CutPlan plan = testing::two_tile_plan();
    const std::size_t one = page_shapes(plan, make_pieces(plan), measure_strain_maps(plan)).size();
    const std::vector<FlatTile> kinds = plan.tiles;
    for (int copy = 0; copy < 9; ++copy)
        for (FlatTile tile : kinds) {
            tile.tile.name += std::to_string(copy);
            plan.tiles.push_back(tile);
        }
    EXPECT_LT(page_shapes(plan, make_pieces(plan), measure_strain_maps(plan)).size(), 6 * one);
}

TEST(PageShapes, LeaveOutWhatAFailedTileDoesNotHave) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].flattening = {};
    const Shapes shapes(page_shapes(plan, make_pieces(plan), measure_strain_maps(plan)));
    EXPECT_FALSE(shapes.text["tiles"][0].contains("flat"));
    EXPECT_EQ(shapes.text["pieces"].size(), 1u);
    EXPECT_EQ(shapes.text["pieces"][0]["tile"], 1);
}

TEST(PageShapes, TellWhereASeamBeginsAndEndsWithinAnEdge) {
    CutPlan plan = testing::two_tile_plan();
    Seam seam;
    seam.id = "S1";
    const Eigen::VectorXd drawn = drawn_lengths(plan.tiles[0].tile);
    seam.a = {0, 0, {{2, 0.25 * drawn[2]}, {3, drawn[3]}, {4, 0.5 * drawn[4]}}};
    seam.b = {1, 0, {{0, 0.5 * drawn_lengths(plan.tiles[1].tile)[0]}}};
    plan.seams = {seam};
    plan.walks = {SeamWalk{}};
    const Shapes shapes(page_shapes(plan, {}, {}));
    const json& a = shapes.text["seams"][0]["a"];
    EXPECT_EQ(a["first"], 2);
    EXPECT_EQ(a["count"], 3);
    EXPECT_NEAR(a["from"].get<double>(), 0.75, 1e-12);
    EXPECT_NEAR(a["to"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(shapes.text["seams"][0]["b"]["from"].get<double>(), 0.25, 1e-12);
}

TEST(PageShapes, HoldWhereAnInflatedEnvelopeIsAndWhatItBears) {
    const CutPlan plan = testing::inflated_plan();
    const Shapes shapes(page_shapes(plan, {}, {}));
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const InflatedTile& tile = plan.inflated->tiles[i];
        const json& said = shapes.text["tiles"][i]["flight"];
        const auto space = shapes.summed<std::uint16_t>(said["space"]["array"], 3);
        ASSERT_EQ(space.size(), static_cast<std::size_t>(tile.positions.size()));
        const double step = said["space"]["step_m"];
        for (std::size_t v = 0; v < space.size(); ++v)
            EXPECT_NEAR(said["space"]["lower_m"][v % 3].get<double>() + step * space[v],
                        tile.positions(static_cast<Eigen::Index>(v / 3), static_cast<Eigen::Index>(v % 3)),
                        0.51 * step);
        const json& maps = shapes.text["tiles"][i]["maps"];
        const auto all_near = [&](const char* map, double value) {
            EXPECT_THAT(shapes.map(maps[map]),
                        ::testing::Each(::testing::DoubleNear(value, 0.51 * maps[map]["step"].get<double>())))
                << map;
            EXPECT_LE(maps[map]["step"], 0.01 * value) << map << " is fine enough";
        };
        all_near("deviation", 0.010);
        all_near("flight-tension", 20.4);
        all_near("flight-warp", 20);
        all_near("flight-weft", 5);
        all_near("flight-strain-warp", 0.01);
        std::vector<double> states(tile.state.size(), 0);
        states[0] = 1;
        states[1] = 2;
        EXPECT_EQ(shapes.map(maps["state"]), states);
    }
    EXPECT_FALSE(Shapes(page_shapes(testing::two_tile_plan(), {}, {})).text["tiles"][0].contains("flight"));
}

class HtmlReport : public ::testing::Test {
  protected:
    void SetUp() override {
        if (page_template().empty()) GTEST_SKIP() << "built without the page (no Node.js)";
    }
};

TEST_F(HtmlReport, HoldsReportAndShapesDeflated) {
    const CutPlan plan = testing::two_tile_plan();
    const std::string text = page(plan);
    const std::string report = between(text, "id=\"ripstop-report\">", "</script>");
    EXPECT_EQ(inflated(decoded(report)), report_json(plan, true));
    const std::string shapes = between(text, "id=\"ripstop-shapes\">", "</script>");
    EXPECT_EQ(inflated(decoded(shapes)), page_shapes(plan, make_pieces(plan), measure_strain_maps(plan)));
}

TEST_F(HtmlReport, HasTheSameBytesEachTime) {
    CutPlan later = testing::two_tile_plan();
    for (FlatTile& tile : later.tiles) tile.seconds *= 2;
    EXPECT_EQ(page(testing::two_tile_plan()), page(later));
}

TEST_F(HtmlReport, TakesNoNameForMarkup) {
    const std::string hostile = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&RIPSTOP_SHAPES";
    const std::string text = page(plan_with_names(hostile, hostile + ".obj"));
    EXPECT_THAT(text, Not(HasSubstr("alert(1)</script>")));
    EXPECT_THAT(text, Not(HasSubstr("<img src=x")));
    EXPECT_THAT(text, HasSubstr("<title>&lt;/script&gt;"));
    const std::string report = inflated(decoded(between(text, "id=\"ripstop-report\">", "</script>")));
    EXPECT_EQ(json::parse(report)["tiles"][0]["name"], hostile);
}

TEST_F(HtmlReport, SaysTheVerdictWithoutScripts) {
    const std::string noscript = between(page(testing::two_tile_plan()), "<noscript><h1>", "</noscript>");
    EXPECT_THAT(noscript, HasSubstr("Not manufacturable as drawn."));
    EXPECT_THAT(noscript, HasSubstr("1 of 2"));
}

TEST_F(HtmlReport, TakesTheRollInAndTheNextInItsPlace) {
    const std::string text = page(testing::two_tile_plan());
    std::optional<PageParts> parts = read_page(text);
    ASSERT_TRUE(parts.has_value());
    EXPECT_EQ(write_page(*parts), text);
    set_roll(*parts, "{\"markers\": []}");
    const std::string first = write_page(*parts);
    EXPECT_EQ(inflated(decoded(between(first, "id=\"ripstop-roll\">", "</script>"))), "{\"markers\": []}");
    parts = read_page(first);
    ASSERT_TRUE(parts.has_value());
    parts->roll = {};
    EXPECT_EQ(write_page(*parts), text);
}

TEST_F(HtmlReport, IsNotReadFromAnotherPage) {
    const std::string text = page(testing::two_tile_plan());
    EXPECT_FALSE(read_page("another page").has_value());
    EXPECT_FALSE(read_page("").has_value());
    EXPECT_FALSE(read_page(text.substr(0, text.size() / 2)).has_value());
    EXPECT_FALSE(read_page(text.substr(1)).has_value());
}

TEST_F(HtmlReport, LoadsNothing) {
    const std::string text = page(testing::two_tile_plan());
    EXPECT_THAT(text, HasSubstr("default-src 'none'"));
    EXPECT_THAT(text, Not(HasSubstr("<script src")));
    EXPECT_THAT(text, Not(HasSubstr("<link rel=\"stylesheet\"")));
}

}  // namespace html_report_test
}  // namespace ripstop
