#include <gmock/gmock.h>

#include <clocale>
#include <locale>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/piece_format.h"
#include "ripstop/io/text/output_file.h"
#include "ripstop/plan_folder/cut_files.h"
#include "support/pattern_pieces.h"

namespace ripstop {

void PrintTo(const PieceFormat& format, std::ostream* out) {
    *out << format.name;
}

namespace every_piece_format_test {

/// Properties of every format of the table.
class EveryPieceFormat : public ::testing::TestWithParam<PieceFormat> {
  protected:
    static std::string written(const std::vector<PatternPiece>& pieces) {
        std::ostringstream out;
        GetParam().write(out, pieces, lay_out(pieces, 0.05), {.style = "balloon.obj", .revision = "B"});
        return out.str();
    }
};

TEST_P(EveryPieceFormat, WritesOddPiecesAlikeEachTime) {
    const std::string bytes = written(testing::odd_pieces());
    EXPECT_GT(bytes.size(), 1000U);
    EXPECT_EQ(bytes, written(testing::odd_pieces()));
}

TEST_P(EveryPieceFormat, WritesNoPiecesToo) {
    EXPECT_GT(written({}).size(), 0U);
    EXPECT_GT(written({PatternPiece{.name = "without outline", .sew_line = Points2(0, 2)}}).size(), 0U);
}

TEST_P(EveryPieceFormat, TakesNamesThatAreNoText) {
    std::vector<PatternPiece> pieces = testing::odd_pieces();
    pieces[0].name = pieces[0].labels[0].text = "cut \xC3 short\x01\n\xFF";
    EXPECT_GT(written(pieces).size(), 1000U);
}

TEST_P(EveryPieceFormat, WritesAThousandPieces) {
    const std::string one = written(testing::many_pieces(1)), bytes = written(testing::many_pieces(1000));
    EXPECT_GT(bytes.size(), 300 * (one.size() / 4));
    EXPECT_LT(bytes.size(), 30'000'000U);
}

TEST_P(EveryPieceFormat, WritesAPieceOfFortyMetres) {
    EXPECT_GT(written({testing::band("long", 40, 1.4, 0.1)}).size(), 1000U);
}

/// Decimal comma and grouped thousands, as in much of the world.
struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST_P(EveryPieceFormat, DoesNotCareForTheLocale) {
    const std::string expected = written(testing::odd_pieces());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // for code that does not use streams, if the system has the locale
    const std::string bytes = written(testing::odd_pieces());
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(before);
    EXPECT_EQ(bytes, expected);
}

TEST_P(EveryPieceFormat, SaysThatTheDiskIsFull) {
    try {
        write_file("/dev/full", [](std::ostream& out) {
            GetParam().write(out, testing::odd_pieces(), std::vector<Vec2>(4, Vec2::Zero()), {});
        });
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("/dev/full: cannot be written: No space left"));
    }
}

INSTANTIATE_TEST_SUITE_P(, EveryPieceFormat, ::testing::ValuesIn(piece_formats().begin(), piece_formats().end()),
                         [](const auto& format) { return format.param.name; });

TEST(PieceFormat, IsRefusedByWhatIsKnown) {
    try {
        piece_format_named("dwg");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("no format \"dwg\" for pieces; known: dxf, svg, pdf, hpgl"));
    }
}

}  // namespace every_piece_format_test
}  // namespace ripstop
