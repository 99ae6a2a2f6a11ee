#include "ripstop/io/svg/svg.h"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>
#include <sstream>

#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/plan_folder/cut_files.h"
#include "support/flat_tiles.h"
#include "support/golden.h"
#include "support/outside.h"
#include "support/pattern_pieces.h"

namespace ripstop {
namespace svg_test {

using ::testing::HasSubstr;

std::string svg(const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {}) {
    std::ostringstream out;
    write_svg(out, pieces, shifts);
    return out.str();
}

/// A right triangle whose upright side is on the left, which distinguishes a mirrored drawing.
PatternPiece triangle(const std::string& name) {
    PatternPiece piece;
    piece.name = name;
    piece.sew_line.resize(3, 2);
    piece.sew_line << 0, 0, 0.2, 0, 0, 0.1;
    return piece;
}

TEST(Svg, IsTrueToSize) {
    // the triangle, 20 mm, the square of 100 mm, and a margin of 10 mm
    EXPECT_THAT(svg({triangle("P")}),
                HasSubstr("width=\"340.000mm\" height=\"120.000mm\" viewBox=\"0 0 340.000 120.000\""));
}

TEST(Svg, TurnsThePieceUpsideDownAndNotLeftToRight) {
    EXPECT_THAT(svg({triangle("P")}), HasSubstr("d=\"M10.000 110.000 L210.000 110.000 L10.000 10.000 Z\""));
    EXPECT_THAT(svg({triangle("P")}, {Vec2(1, 1)}),
                HasSubstr("d=\"M10.000 110.000 L210.000 110.000 L10.000 10.000 Z\""));
}

TEST(Svg, TurnsUprightLabelsCounterClockwise) {
    PatternPiece piece = triangle("P");
    piece.labels = {{"up", Vec2(0.02, 0.03), 0.01, std::acos(0.0)}};
    EXPECT_THAT(svg({piece}), HasSubstr("transform=\"translate(30.000 80.000) rotate(-90.000)\" y=\"5.000\""));
}

TEST(Svg, GivesEachPieceItsOwnId) {
    const std::string text = svg({triangle("Bílý <1>"), triangle("Bílý <1>"), triangle(""), triangle("reference")},
                                 std::vector<Vec2>(4, Vec2::Zero()));
    EXPECT_THAT(text, HasSubstr("<g id=\"Bílý_&lt;1&gt;\" data-name=\"Bílý &lt;1&gt;\" inkscape:groupmode=\"layer\""));
    EXPECT_THAT(text, HasSubstr("<g id=\"Bílý_&lt;1&gt;-2\""));
    EXPECT_THAT(text, HasSubstr("<g id=\"piece\""));
    EXPECT_THAT(text, HasSubstr("<g id=\"reference-2\" data-name=\"reference\" "));
}

TEST(Svg, IsWellFormedForAnotherReader) {
    const std::string python = testing::python_with("xml.etree.ElementTree");
    if (python.empty()) GTEST_SKIP() << "no Python here";
    const testing::ScratchDirectory scratch;
    const std::vector<PatternPiece> pieces = make_pieces(testing::two_tile_plan());
    testing::write_text(scratch.path("plan.svg"), svg(pieces, lay_out(pieces, 0.02)));
    testing::write_text(scratch.path("read.py"), R"(import sys, xml.etree.ElementTree as tree
root = tree.parse(sys.argv[1]).getroot()
ids = [e.get('id') for e in root.iter() if e.get('id')]
print(len(ids), len(set(ids)), ids[1], [e.text for e in root.iter('{http://www.w3.org/2000/svg}text')][2])
)");
    const auto result =
        testing::run_command(python + " -X utf8 " + scratch.path("read.py") + " " + scratch.path("plan.svg"));
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.output, "3 3 Bílý_\"dráček\" Bílý \"dráček\"\n");
}

TEST(Svg, IsRenderedWithASquareOfHundredMillimetres) {
    if (testing::run_command("rsvg-convert --version").code != 0) GTEST_SKIP() << "no rsvg-convert here";
    const std::string python = testing::python_with("zlib");
    if (python.empty()) GTEST_SKIP() << "no Python here";
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("p.svg"), svg({triangle("P")}));
    const auto rendered = testing::run_command("rsvg-convert -d 127 -p 127 -b white -o " + scratch.path("p.png") + " " +
                                               scratch.path("p.svg"));
    ASSERT_EQ(rendered.code, 0) << rendered.output;
    // At 127 dpi a pixel is 0.2 mm. Only the square is grey: look for its left and right strokes in a row.
    testing::write_text(scratch.path("read.py"), R"(import struct, sys, zlib
data = open(sys.argv[1], 'rb').read()
at, packed = 8, b''
while at < len(data):
    size, kind = struct.unpack('>I4s', data[at:at + 8])
    body = data[at + 8:at + 8 + size]
    if kind == b'IHDR': width, height, depth, colour = struct.unpack('>IIBB', body[:10])
    if kind == b'IDAT': packed += body
    at += 12 + size
channels = {2: 3, 6: 4}[colour]
raw, stride, rows, before = zlib.decompress(packed), width * channels, [], bytes(width * channels)
for y in range(101):
    how, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
    for i in range(stride):
        a, b, c = (line[i - channels] if i >= channels else 0), before[i], (before[i - channels] if i >= channels else 0)
        p = a + b - c
        pick = a if abs(p - a) <= abs(p - b) and abs(p - a) <= abs(p - c) else b if abs(p - b) <= abs(p - c) else c
        line[i] = (line[i] + (0, a, b, (a + b) // 2, pick)[how]) & 255
    rows.append(line); before = line
row = rows[100]
grey = [x for x in range(width) if row[x * channels] == row[x * channels + 2] < 240]
print(width, height, grey[0], grey[-1])
)");
    const auto result = testing::run_command(python + " " + scratch.path("read.py") + " " + scratch.path("p.png"));
    ASSERT_EQ(result.code, 0) << result.output;
    std::istringstream in(result.output);
    int width = 0, height = 0, left = 0, right = 0;
    in >> width >> height >> left >> right;
    EXPECT_EQ(width, 1700);
    EXPECT_EQ(height, 600);
    EXPECT_NEAR(left, 1150, 1.5);
    EXPECT_NEAR(right - left, 500, 1.5) << "100 mm in pixels of 0.2 mm, give or take what a hairline covers";
}

TEST(Svg, SaysOfEachEdgeWhatItIsSewnTo) {
    const std::string text = svg({testing::band("P", 0.5, 0.3)});
    EXPECT_THAT(text, HasSubstr("data-edge=\"1\" data-seam=\"S001\" data-mate=\"neighbour below\" "
                                "data-type=\"flat-felled\" data-length-mm=\"500.000\" data-allowance-mm=\"12.000\""));
    EXPECT_THAT(text, HasSubstr("data-edge=\"2\" data-type=\"hem\" data-length-mm=\"300.000\""));
    EXPECT_THAT(text, HasSubstr("data-edge=\"3\" data-seam=\"S002 S003\" data-mate=\"Bílý, C\""));
}

TEST(Svg, HasALayerForEachKindOfLine) {
    const std::string text = svg({testing::band("P", 0.5, 0.3)});
    std::size_t at = text.find("<g id=\"P\"");
    for (const char* layer : {"P", "cut", "sew", "notch", "internal", "grain", "text", "reference"}) {
        at = text.find("inkscape:groupmode=\"layer\" inkscape:label=\"" + std::string(layer) + "\"", at);
        ASSERT_NE(at, std::string::npos) << layer;
    }
    EXPECT_THAT(svg({triangle("P")}), ::testing::Not(HasSubstr("label=\"sew\""))) << "no empty layers";
}

TEST(Svg, IsMeasuredInTrueSizeByInkscape) {
    if (testing::run_command("inkscape --version").code != 0) GTEST_SKIP() << "no Inkscape here";
    const testing::ScratchDirectory scratch;
    const PatternPiece piece = testing::band("P", 0.5, 0.3);
    testing::write_text(scratch.path("p.svg"), svg({piece}));
    const auto measured = [&scratch](const std::string& id, const std::string& what) {
        const auto result = testing::run_command("(env HOME=" + scratch.path() + " inkscape --query-id=" + id +
                                                 " --query-" + what + " " + scratch.path("p.svg") + " 2> /dev/null)");
        EXPECT_EQ(result.code, 0) << result.output;
        return std::strtod(result.output.c_str(), nullptr) * 25.4 / 96;  // its pixels are 1/96 in
    };
    // Inkscape adds a line's width and rounds to six digits.
    constexpr double line = 0.2;
    EXPECT_NEAR(measured("reference", "width"), 100 + line, 0.01);
    EXPECT_NEAR(measured("P", "width"), 524 + line, 0.01) << "500 mm and the allowances";
    EXPECT_NEAR(measured("P", "height"), 324 + line, 0.01);
}

Points2 points_of(const std::string& path) {
    const std::regex number("(-?[0-9.]+) (-?[0-9.]+)");
    std::vector<Vec2> points;
    for (std::sregex_iterator p(path.begin(), path.end(), number), end; p != end; ++p)
        points.emplace_back(std::stod((*p)[1]), std::stod((*p)[2]));
    Points2 rows(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
}

TEST(Svg, LeavesTheAllowanceItStatesBetweenEachEdgeAndTheCutLine) {
    for (const PatternPiece& piece : make_pieces(testing::two_tile_plan())) {
        const std::string text = svg({piece});
        std::smatch cut;
        ASSERT_TRUE(std::regex_search(text, cut, std::regex("class=\"cut\"[^>]* d=\"([^\"]*) Z\"")));
        const Points2 outline = points_of(cut[1]);
        const std::regex sew("class=\"sew\"[^>]*data-allowance-mm=\"([0-9.]+)\" d=\"([^\"]*)\"");
        int edges = 0;
        for (std::sregex_iterator edge(text.begin(), text.end(), sew), end; edge != end; ++edge, ++edges) {
            const double allowance = std::stod((*edge)[1]);
            const Points2 line = points_of((*edge)[2]);
            EXPECT_GT(allowance, 1);
            for (Eigen::Index i = 0; i < line.rows(); ++i) EXPECT_TRUE(contains(outline, Vec2(line.row(i))));
            // away from the corners, where the neighbour's allowance matters; both lines simplify curves by 0.05
            // mm
            const Vec2 middle = (line.row((line.rows() - 1) / 2) + line.row(line.rows() / 2)) / 2;
            EXPECT_NEAR(distance_to_outline(outline, middle), allowance, 0.1) << piece.name << " edge " << edges + 1;
        }
        EXPECT_EQ(edges, static_cast<int>(piece.edges.size()));
    }
}

TEST(Svg, IsWhatItWasLastTime) {
    testing::expect_golden("band.svg", svg({testing::band("G01P01", 0.25, 0.12, 0.01)}));
}

}  // namespace svg_test
}  // namespace ripstop
