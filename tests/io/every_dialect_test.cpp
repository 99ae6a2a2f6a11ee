#include <gmock/gmock.h>

#include <algorithm>
#include <clocale>
#include <filesystem>
#include <locale>
#include <set>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/dxf/dxf.h"
#include "ripstop/io/dxf/dxf_dialect.h"
#include "ripstop/io/dxf/dxf_read.h"
#include "ripstop/io/dxf/moved_piece.h"
#include "ripstop/pattern/drawing/check_drawing.h"
#include "support/dxf_pieces.h"
#include "support/outside.h"

namespace ripstop {

void PrintTo(const DxfDialect& dialect, std::ostream* out) {
    *out << dialect.name;
}

namespace every_dialect_test {

using testing::dxf_entities;
using testing::dxf_of;
using testing::dxf_pairs;
using testing::DxfPairs;
using testing::sample_piece;
using testing::sample_pieces;
using testing::value_of;

/// A contour as found by a reader, in millimetres.
struct ReadContour {
    std::string block, layer;
    Vec2 lower;
    double area = 0, perimeter = 0;
    int parts = 0, closed = 0;
};

/// Properties of every dialect of the table, whatever the reader.
class EveryDialect : public ::testing::TestWithParam<DxfDialect> {
  protected:
    static std::string written(const std::vector<PatternPiece>& pieces) { return dxf_of(pieces, GetParam().name); }

    static PatternDrawing read(const std::string& text) {
        std::istringstream in(text);
        return read_dxf(in, "pieces.dxf");
    }

    static DrawingCheck checked(const std::vector<PatternPiece>& pieces) {
        return check_drawing(read(written(pieces)));
    }

    static std::string cut_layer() { return GetParam().blocks ? "1" : "CUT"; }
    static std::string sew_layer() { return GetParam().blocks ? "14" : "SEW"; }

    /// The pieces as the dialect rotates them, with the same lower left corner.
    static std::vector<PatternPiece> turned(const std::vector<PatternPiece>& pieces) {
        std::vector<PatternPiece> result;
        Vec2 was = pieces.front().lower(), is = Vec2::Constant(1e9);
        for (const PatternPiece& piece : pieces) {
            result.push_back(moved_piece(piece, Vec2::Zero(), GetParam().grain_up));
            was = was.cwiseMin(piece.lower());
            is = is.cwiseMin(result.back().lower());
        }
        for (PatternPiece& piece : result) piece = moved_piece(piece, was - is);
        return result;
    }

    /// Coordinates are rounded by up to 0.05 um. So the perimeter of some hundred points changes by at most a
    /// hundredth of a millimetre, and the area by at most 0.05 um times the perimeter.
    static void expect_contours(const std::vector<ReadContour>& found, const std::vector<PatternPiece>& pieces) {
        std::vector<std::pair<std::string, const Points2*>> expected;
        const std::vector<PatternPiece> drawn = turned(pieces);
        for (const PatternPiece& piece : drawn) {
            expected.emplace_back(cut_layer(), &piece.cut_line);
            if (!GetParam().blocks ||
                !(piece.cut_line.rows() == piece.sew_line.rows() && piece.cut_line == piece.sew_line))
                expected.emplace_back(sew_layer(), &piece.sew_line);
        }
        std::vector<ReadContour> contours;
        for (const ReadContour& contour : found)
            if (contour.layer == cut_layer() || contour.layer == sew_layer()) contours.push_back(contour);
        ASSERT_EQ(contours.size(), expected.size());
        for (std::size_t i = 0; i < contours.size(); ++i) {
            const auto& [layer, line] = expected[i];
            EXPECT_EQ(contours[i].layer, layer);
            EXPECT_EQ(contours[i].closed, 1);
            EXPECT_NEAR(contours[i].perimeter, 1e3 * perimeter(*line), 0.01);
            EXPECT_NEAR(contours[i].area, 1e6 * signed_area(*line), 1e-4 * contours[i].perimeter);
            const Vec2 lower = line->colwise().minCoeff() * 1e3;
            EXPECT_NEAR(contours[i].lower.x(), lower.x(), 1e-4);
            EXPECT_NEAR(contours[i].lower.y(), lower.y(), 1e-4);
        }
    }

    static std::vector<ReadContour> contours_in(std::istream& in) {
        std::vector<ReadContour> contours;
        ReadContour c;
        while (in >> c.block >> c.layer >> c.lower.x() >> c.lower.y() >> c.area >> c.perimeter >> c.parts >> c.closed)
            contours.push_back(c);
        return contours;
    }
};

TEST_P(EveryDialect, IsReadBackWithEveryContourWhereItWas) {
    const std::vector<PatternPiece> pieces = sample_pieces();
    const PatternDrawing drawing = read(written(pieces));
    EXPECT_TRUE(drawing.unread.empty());
    const std::vector<PatternPiece> drawn = turned(pieces);
    const DrawingCheck check = check_drawing(drawing);
    EXPECT_TRUE(check.sound()) << (check.issues.empty() ? "" : check.issues.front().message);
    std::vector<const DrawingContour*> cut;
    for (const DrawingContour& contour : check.contours)
        if (contour.is_cut) cut.push_back(&contour);
    ASSERT_EQ(cut.size(), pieces.size());
    for (const DrawingContour* contour : cut) {
        const auto its = std::find_if(drawn.begin(), drawn.end(), [&](const PatternPiece& piece) {
            return (piece.lower() - contour->lower).norm() < 1e-6 && (piece.upper() - contour->upper).norm() < 1e-6;
        });
        ASSERT_NE(its, drawn.end()) << contour->piece;
        EXPECT_NEAR(contour->area, signed_area(its->cut_line), 1e-7 * contour->perimeter);
        EXPECT_NEAR(contour->perimeter, perimeter(its->cut_line), 1e-5);
    }
}

TEST_P(EveryDialect, IsReadByEzdxfWithoutErrorsAndWithTheSameContours) {
    const std::string python = testing::python_with("ezdxf");
    if (python.empty()) GTEST_SKIP() << "no Python with ezdxf here";
    const testing::ScratchDirectory scratch;
    const std::vector<PatternPiece> pieces = sample_pieces();
    testing::write_text(scratch.path("p.dxf"), written(pieces));
    const auto run =
        testing::run_command(python + " " RIPSTOP_SOURCE_DIR "/tests/dxf/contours.py " + scratch.path("p.dxf"));
    ASSERT_EQ(run.code, 0) << run.output;
    std::istringstream in(run.output);
    std::string release;
    int units = -1, errors = -1;
    in >> release >> units >> errors;
    EXPECT_EQ(release, "AC1009") << "ezdxf takes Release 10 up to 12";
    EXPECT_EQ(units, GetParam().states_insunits ? 4 : 0);
    EXPECT_EQ(errors, 0) << run.output;
    expect_contours(contours_in(in), pieces);
}

TEST_P(EveryDialect, IsReadByDxfParserWithTheSameContours) {
    if (!std::filesystem::exists(RIPSTOP_SOURCE_DIR "/tests/dxf/node_modules/dxf-parser"))
        GTEST_SKIP() << "no dxf-parser here: npm ci in tests/dxf";
    const testing::ScratchDirectory scratch;
    const std::vector<PatternPiece> pieces = sample_pieces();
    testing::write_text(scratch.path("p.dxf"), written(pieces));
    const auto run = testing::run_command("node " RIPSTOP_SOURCE_DIR "/tests/dxf/parse.mjs " + scratch.path("p.dxf"));
    ASSERT_EQ(run.code, 0) << run.output;
    std::istringstream in(run.output);
    expect_contours(contours_in(in), pieces);
}

TEST_P(EveryDialect, IsDrawnByLibreCad) {
    if (testing::run_command("command -v librecad").code != 0) GTEST_SKIP() << "no librecad here";
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("p.dxf"), written(sample_pieces()));
    const auto run = testing::run_command("cd " + scratch.path() + " && HOME=" + scratch.path() +
                                          " QT_QPA_PLATFORM=offscreen timeout 60 librecad dxf2pdf -a -k p.dxf");
    ASSERT_EQ(run.code, 0) << run.output;
    // An empty sheet is smaller than 2 kB.
    EXPECT_GT(testing::content(scratch.path("p.pdf")).size(), 4000U);
}

/// The German number format, without the locale being installed.
struct CommaAndThousands : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST_P(EveryDialect, WritesTheSameBytesInAnyLocaleAndTwice) {
    const std::string text = written(sample_pieces());
    EXPECT_EQ(written(sample_pieces()), text);
    std::locale::global(std::locale(std::locale::classic(), new CommaAndThousands));
    EXPECT_EQ(written(sample_pieces()), text);
    EXPECT_TRUE(checked(sample_pieces()).sound());
    std::locale::global(std::locale::classic());
    for (const char* name : {"de_DE.UTF-8", "cs_CZ.UTF-8", "fr_FR.UTF-8"}) {
        try {
            std::locale::global(std::locale(name));
        } catch (const std::runtime_error&) {
            continue;  // not installed
        }
        EXPECT_EQ(written(sample_pieces()), text) << name;
        std::locale::global(std::locale::classic());
    }
}

TEST_P(EveryDialect, StaysAsciiWithSymbolsThatRelease12Knows) {
    const std::vector<PatternPiece> pieces{sample_piece("Bílý\ndráček 100%%d ^J", {0, 0}),
                                           sample_piece("Bíly draček 100__D _J", {1, 0}),
                                           sample_piece("", {2, 0}),
                                           sample_piece("", {3, 0}),
                                           sample_piece("a name that is far too long for a symbol 1", {4, 0}),
                                           sample_piece("a name that is far too long for a symbol 2", {5, 0}),
                                           sample_piece("\xE6\xBC\xA2\xE5\xAD\x97", {6, 0})};
    const std::string text = written(pieces);
    EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; }));
    EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr("%%")));
    EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr("^")));
    std::set<std::string> names;
    for (const DxfPairs& block : dxf_entities(dxf_pairs(text), "BLOCK")) {
        const std::string name = value_of(block, 2);
        EXPECT_LE(name.size(), 31U);
        EXPECT_EQ(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"), std::string::npos) << name;
        EXPECT_TRUE(names.insert(name).second) << name;
    }
    EXPECT_EQ(names.size(), GetParam().blocks ? pieces.size() : 0U);
    EXPECT_TRUE(checked(pieces).sound());
}

TEST_P(EveryDialect, KeepsAPieceOf40Metres) {
    const std::vector<PatternPiece> pieces{sample_piece("strip", {1000, -1000}, {40, 1.4})};
    const DrawingCheck check = checked(pieces);
    ASSERT_TRUE(check.sound());
    EXPECT_NEAR(check.contours.front().perimeter, 2 * (40.02 + 1.42), 1e-6);
}

TEST_P(EveryDialect, KeepsAThousandPiecesApart) {
    std::vector<PatternPiece> pieces;
    for (int i = 0; i < 1000; ++i)
        pieces.push_back(
            sample_piece(std::string("P").append(std::to_string(i)), Vec2(0.5 * (i % 40), 0.3 * (i / 40))));
    const DrawingCheck check = checked(pieces);
    EXPECT_TRUE(check.sound()) << check.issues.front().message;
    EXPECT_EQ(check.contours.size(), 2000U);
    std::set<std::string> names;
    for (const DrawingContour& contour : check.contours) names.insert(contour.piece);
    EXPECT_EQ(names.size(), 1000U);
}

TEST_P(EveryDialect, WritesNoPointTwiceInARowAndNoFirstPointAgain) {
    for (const DrawnPath& path : read(written(sample_pieces())).paths) {
        if (path.entity != "POLYLINE") continue;
        for (Eigen::Index i = 1; i < path.points.rows(); ++i) EXPECT_NE(path.points.row(i), path.points.row(i - 1));
        if (path.is_closed) {
            EXPECT_NE(path.points.row(0), path.points.row(path.points.rows() - 1));
        }
    }
}

TEST_P(EveryDialect, DeclaresEveryLayerWhereItDeclaresAny) {
    const PatternDrawing drawing = read(written(sample_pieces()));
    const std::set<std::string> declared(drawing.declared_layers.begin(), drawing.declared_layers.end());
    EXPECT_EQ(declared.empty(), !GetParam().tables);
    if (declared.empty()) return;
    for (const DrawnPath& path : drawing.paths) EXPECT_TRUE(declared.contains(path.layer)) << path.layer;
    for (const DrawnPoint& point : drawing.points) EXPECT_TRUE(declared.contains(point.layer)) << point.layer;
    for (const DrawnText& text : drawing.texts) EXPECT_TRUE(declared.contains(text.layer)) << text.layer;
}

TEST_P(EveryDialect, TurnsTheGrainWhereAsked) {
    for (const char* axis : {"x", "y"}) {
        DxfOptions options;
        options.grain_axis = axis;
        const PatternDrawing drawing = read(dxf_of({sample_piece("A")}, GetParam().name, options));
        const std::string layer = GetParam().blocks ? "7" : "GRAIN";
        const auto grain = std::find_if(drawing.paths.begin(), drawing.paths.end(),
                                        [&layer](const DrawnPath& path) { return path.layer == layer; });
        ASSERT_NE(grain, drawing.paths.end());
        const Vec2 along = (grain->points.row(1) - grain->points.row(0)).transpose();
        EXPECT_NEAR(std::string(axis) == "x" ? along.x() : along.y(), 200, 1e-4);
        EXPECT_NEAR(std::string(axis) == "x" ? along.y() : along.x(), 0, 1e-4);
    }
    DxfOptions wrong;
    wrong.grain_axis = "z";
    EXPECT_THROW(dxf_of({sample_piece("A")}, GetParam().name, wrong), InputError);
}

TEST_P(EveryDialect, WritesADrawingWithoutPieces) {
    EXPECT_NO_THROW(read(written({})));
}

INSTANTIATE_TEST_SUITE_P(Dxf, EveryDialect, ::testing::ValuesIn(dxf_dialects()),
                         [](const auto& dialect) { return dialect.param.name; });

TEST(DxfDialect, NamesTheKnownOnesWhereAnotherIsAskedFor) {
    try {
        dxf_dialect_named("lectra");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "no DXF dialect \"lectra\"; known: cam, aama, astm, gerber, clo, et");
    }
}

}  // namespace every_dialect_test
}  // namespace ripstop
