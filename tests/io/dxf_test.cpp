#include "ripstop/io/dxf/dxf.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/plan_folder/cut_files.h"
#include "support/dxf_pieces.h"
#include "support/flat_tiles.h"
#include "support/outside.h"

namespace ripstop {
namespace dxf_test {

std::string dxf(const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts = {}) {
    std::ostringstream out;
    write_dxf(out, pieces, shifts);
    return out.str();
}

std::string after(const testing::DxfPairs& all, const std::string& variable) {
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
        if (all[i].second == variable) return all[i + 1].second;
    return "";
}

TEST(Dxf, IsRelease12InMillimetres) {
    const testing::DxfPairs all = testing::dxf_pairs(dxf({testing::piece_of(testing::flat_cylinder("G01P01"))}));
    EXPECT_EQ(after(all, "$ACADVER"), "AC1009");
    EXPECT_EQ(after(all, "$INSUNITS"), "4");
    EXPECT_EQ(after(all, "$MEASUREMENT"), "1");
    EXPECT_EQ(after(all, "$EXTMIN"), "-25.0000") << "a hem all round";
    EXPECT_EQ(all.back(), (std::pair<int, std::string>(0, "EOF")));
    const std::set<std::string> known{"SECTION",  "ENDSEC", "TABLE",  "ENDTAB", "LTYPE", "LAYER", "STYLE",
                                      "POLYLINE", "VERTEX", "SEQEND", "LINE",   "TEXT",  "EOF"};
    for (const auto& [code, value] : all) EXPECT_TRUE(code != 0 || known.count(value) == 1) << value;
}

TEST(Dxf, DeclaresEveryLayerItUses) {
    std::set<std::string> declared, used;
    std::string entity;
    for (const auto& [code, value] : testing::dxf_pairs(dxf({testing::piece_of(testing::flat_cylinder("G01P01"))}))) {
        if (code == 0) entity = value;
        if (code == 2 && entity == "LAYER") declared.insert(value);
        if (code == 8) used.insert(value);
    }
    EXPECT_EQ(used, (std::set<std::string>{"CUT", "SEW", "GRAIN", "TEXT", "REF"}));
    EXPECT_TRUE(std::includes(declared.begin(), declared.end(), used.begin(), used.end()));
    EXPECT_EQ(declared.count("NOTCH") + declared.count("INTERNAL"), 2u) << "and those that other pieces use";
}

TEST(Dxf, WritesOneClosedPolylineWithoutRepeatedCorners) {
    PatternPiece piece;
    piece.name = "P";
    piece.sew_line.resize(6, 2);
    // the second corner differs from the first by less than the written precision, and so does the last
    piece.sew_line << 0, 0, 1e-9, 0, 1, 0, 1, 1, 0, 1, 0, 1e-9;
    int vertices = 0, contours = 0;
    std::string entity, layer;
    for (const auto& [code, value] : testing::dxf_pairs(dxf({piece}))) {
        if (code == 0) entity = value;
        if (code == 8) layer = value;
        if (code == 8 && entity == "VERTEX" && layer == "SEW") ++vertices;
        if (code == 70 && entity == "POLYLINE" && layer == "SEW") {
            EXPECT_EQ(value, "1");
            ++contours;
        }
    }
    EXPECT_EQ(contours, 1);
    EXPECT_EQ(vertices, 4);
}

TEST(Dxf, StaysAsciiWhateverTheName) {
    PatternPiece piece = testing::piece_of(testing::flat_cylinder("Bílý\ndráček 100%%d"));
    const std::string text = dxf({piece});
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; }));
    EXPECT_THAT(text, ::testing::HasSubstr("Bily dracek 100%d\r\n"));
}

TEST(Dxf, RefusesShiftsThatDoNotMatchThePieces) {
    const PatternPiece piece = testing::piece_of(testing::flat_cylinder("G01P01"));
    EXPECT_THROW(dxf({piece, piece}, {Vec2(0, 0)}), InputError);
}

TEST(Dxf, IsReadByAnotherReaderWithTheSameAreaAndPerimeter) {
    const std::string python = testing::python_with("ezdxf");
    if (python.empty()) GTEST_SKIP() << "no Python with ezdxf here";
    const testing::ScratchDirectory scratch;
    const CutPlan plan = testing::two_tile_plan();
    const std::vector<PatternPiece> pieces = make_pieces(plan);
    testing::write_text(scratch.path("plan.dxf"), dxf(pieces, lay_out(pieces, 0.02)));
    testing::write_text(scratch.path("read.py"), R"(import ezdxf, sys
from math import dist
doc = ezdxf.readfile(sys.argv[1])
audit = doc.audit()
print(doc.dxfversion, doc.units, len(audit.errors), len(audit.fixes))
for line in doc.modelspace().query('POLYLINE'):
    p = [v.dxf.location for v in line.vertices]
    n = len(p)
    area = sum(p[i].x * p[(i + 1) % n].y - p[i].y * p[(i + 1) % n].x for i in range(n)) / 2
    print(line.dxf.layer, int(line.is_closed), repr(area), repr(sum(dist(p[i], p[(i + 1) % n]) for i in range(n))))
)");
    const auto result = testing::run_command(python + " " + scratch.path("read.py") + " " + scratch.path("plan.dxf"));
    ASSERT_EQ(result.code, 0) << result.output;
    std::istringstream in(result.output);
    std::string release, layer;
    int units = 0, errors = -1, fixes = -1, closed = 0;
    in >> release >> units >> errors >> fixes;
    EXPECT_EQ(release, "AC1009");
    EXPECT_EQ(units, 4);
    EXPECT_EQ(errors, 0);
    EXPECT_EQ(fixes, 0);
    double area = 0, length = 0;
    for (const PatternPiece& piece : pieces) {
        for (const auto& [name, outline] : {std::pair("CUT", &piece.cut_line), std::pair("SEW", &piece.sew_line)}) {
            ASSERT_TRUE(in >> layer >> closed >> area >> length) << result.output;
            EXPECT_EQ(layer, name);
            EXPECT_EQ(closed, 1);
            // Corners are rounded by up to 0.05 um, which adds up to far less than 0.01 mm along the outline.
            EXPECT_NEAR(length, 1e3 * perimeter(*outline), 0.01);
            EXPECT_NEAR(area, 1e6 * signed_area(*outline), 1e-4 * length);
        }
    }
    ASSERT_TRUE(in >> layer >> closed >> area >> length);
    EXPECT_EQ(layer, "REF");
    EXPECT_EQ(length, 400);
}

}  // namespace dxf_test
}  // namespace ripstop
