#include "ripstop/io/print/pdf.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/print/paper.h"
#include "support/outside.h"
#include "support/pattern_pieces.h"
#include "support/raster.h"
#include "support/sanitized.h"

namespace ripstop {
namespace pdf_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::string pdf(const std::vector<PatternPiece>& pieces, const std::string& paper = "roll",
                const std::string& date = "") {
    std::ostringstream out;
    write_pdf(out, pieces, {"balloon.obj", "B", paper, date});
    return out.str();
}

/// A PDF in its own folder, as poppler's programs see it.
class PrintedFile {
  public:
    explicit PrintedFile(const std::string& bytes) { testing::write_text(file(), bytes); }

    static bool can_be_read() { return testing::run_command("pdftoppm -v").code == 0; }
    std::string told_by(const std::string& command, const std::string& after = "") const {
        const auto result = testing::run_command(command + " " + file() + " " + after);
        EXPECT_EQ(result.code, 0) << result.output;
        EXPECT_THAT(result.output, Not(HasSubstr("Error"))) << command;
        return result.output;
    }
    testing::Raster page(int number, double dots_per_mm) const {
        const std::string n = std::to_string(number);
        told_by("pdftoppm -r " + std::to_string(25.4 * dots_per_mm) + " -f " + n + " -l " + n + " -singlefile",
                scratch_.path("page"));
        return testing::read_ppm(scratch_.path("page.ppm"));
    }
    /// The length of all lines of a page in the colour of cuts, red [m].
    double red_length(int number) const {
        const std::string n = std::to_string(number);
        told_by("pdftocairo -svg -f " + n + " -l " + n, scratch_.path("page.svg"));
        const std::string svg = testing::content(scratch_.path("page.svg"));
        // pdftocairo fits the page with a matrix; the path itself is in points
        const std::regex path("<path style=\"[^\"]*stroke:rgb\\(79.9[0-9]*%,0%,0%\\)[^\"]*\" d=\"([^\"]*)\"");
        const std::regex step("([MLZ]) ?(-?[0-9.]*) ?(-?[0-9.]*)");
        double sum = 0;
        for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
            const std::string d = (*it)[1];
            Vec2 first(0, 0), at(0, 0);
            for (std::sregex_iterator s(d.begin(), d.end(), step), none; s != none; ++s) {
                const Vec2 to = (*s)[1] == "Z" ? first : Vec2(std::stod((*s)[2]), std::stod((*s)[3]));
                if ((*s)[1] == "M") first = to;
                if ((*s)[1] != "M") sum += (to - at).norm();
                at = to;
            }
        }
        return sum * 0.0254 / 72;
    }

  private:
    std::string file() const { return scratch_.path("p.pdf"); }
    testing::ScratchDirectory scratch_;
};

#define RIPSTOP_REQUIRE_POPPLER() \
    if (!PrintedFile::can_be_read()) GTEST_SKIP() << "no poppler-utils here"

/// The positions, from the left, of solid upright grey lines that are at least `tall` dots high: the middles of
/// their dots. Other lines may cross them.
std::vector<double> grey_uprights(const testing::Raster& raster, int tall) {
    std::vector<double> middles;
    int begin = -1;
    for (int x = 0; x <= raster.width; ++x) {
        int count = 0, grey = 0, run = 0;
        for (int y = 0; x < raster.width && y < raster.height; ++y) {
            const bool is_drawn = raster.at(x, y) != std::array{255, 255, 255};
            run = is_drawn ? run + 1 : 0;
            grey = is_drawn ? grey + raster.is_grey(x, y) : 0;
            if (grey > 0.9 * run) count = std::max(count, run);
        }
        if (count >= tall && begin < 0) begin = x;
        if (count < tall && begin >= 0) {
            middles.push_back((begin + x - 1) / 2.0);
            begin = -1;
        }
    }
    return middles;
}

TEST(Pdf, HasASquareOfHundredMillimetresOnEveryPage) {
    RIPSTOP_REQUIRE_POPPLER();
    for (const char* paper : {"roll", "a4", "letter"}) {
        const PrintedFile file(pdf({testing::band("P", 0.6, 0.1)}, paper));
        const std::string info = file.told_by("pdfinfo");
        const int pages = std::stoi(info.substr(info.find("Pages:") + 6));
        for (int page = std::string(paper) == "roll" ? 2 : 3; page <= pages; ++page) {
            // 10 dots per mm; frame, side, side, frame
            const std::vector<double> lines = grey_uprights(file.page(page, 10), 900);
            ASSERT_EQ(lines.size(), 4U) << paper << " page " << page;
            EXPECT_NEAR(lines[2] - lines[1], 1000, 1) << paper << " page " << page;
            EXPECT_NEAR(lines[0], 120, 1) << "the margin of 12 mm";
        }
    }
}

TEST(Pdf, CutsEachPieceAtItsLength) {
    RIPSTOP_REQUIRE_POPPLER();
    std::vector<PatternPiece> pieces = testing::odd_pieces();
    for (PatternPiece& piece : pieces) piece.notches.clear();
    const PrintedFile file(pdf(pieces));
    // cairo rounds to 1/256 point, 1.4 micrometres: half of it per end, two ends per segment, 50 segments
    for (std::size_t i = 0; i < pieces.size(); ++i)
        EXPECT_NEAR(file.red_length(2 + static_cast<int>(i)), testing::cut_length(pieces[i]), 0.1e-3) << i;
}

TEST(Pdf, SpreadsFortyMetresOverPagesOfARoll) {
    RIPSTOP_REQUIRE_POPPLER();
    PatternPiece piece = testing::band("long", 40, 1.4);
    piece.notches.clear();
    const PrintedFile file(pdf({piece}));
    EXPECT_THAT(file.told_by("pdfinfo"), HasSubstr("Pages:           11\n")) << "cover, map, nine of 4.5 m";
    double sum = 0;
    for (int page = 3; page <= 11; ++page) sum += file.red_length(page);
    const double twice = 8 * 2 * Paper::overlap;
    EXPECT_NEAR(sum, testing::cut_length(piece) + twice, 0.2e-3) << "all of it, and twice what two pages share";
}

/// The pages of a piece joined by their names on the map; only the step and the overlap are used.
testing::Raster joined(const PrintedFile& file, const PageGrid& grid, int first_page, int dots) {
    const Vec2 step = grid.page - Vec2::Constant(2 * Paper::margin + Paper::overlap);
    const auto dots_of = [dots](double length) { return static_cast<int>(std::lround(length * 1000 * dots)); };
    const int margin = dots_of(Paper::margin);
    testing::Raster sheet;
    sheet.width = dots_of(step.x() * grid.columns + Paper::overlap);
    sheet.height = dots_of(step.y() * grid.rows + Paper::overlap);
    sheet.rgb.assign(3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), 255);
    for (std::size_t i = 0; i < grid.windows.size(); ++i) {
        const testing::Raster page = file.page(first_page + static_cast<int>(i), dots);
        const int left = dots_of(step.x() * grid.windows[i].column), top = dots_of(step.y() * grid.windows[i].row);
        for (int y = margin; y < page.height - margin; ++y)
            for (int x = margin; x < page.width - margin; ++x) {
                if (!page.is_red(x, y)) continue;
                const auto at =
                    3 * (static_cast<std::size_t>(top + y - margin) * static_cast<std::size_t>(sheet.width) +
                         static_cast<std::size_t>(left + x - margin));
                sheet.rgb[at + 1] = sheet.rgb[at + 2] = 0;
            }
    }
    return sheet;
}

TEST(Pdf, PagesLaidTogetherAreThePiece) {
    RIPSTOP_REQUIRE_POPPLER();
    PatternPiece piece = testing::band("P", 0.9, 0.6, 0.08);
    piece.notches.clear();
    const PrintedFile file(pdf({piece}, "a4"));
    const PageGrid grid = make_page_grid(piece, paper_named("a4"));
    ASSERT_GT(grid.windows.size(), 9U);
    constexpr int dots = 4;  // per mm
    const testing::Raster sheet = joined(file, grid, 3, dots);
    // The piece is centred on its pages.
    const Vec2 middle = (piece.lower() + piece.upper()) / 2;
    const auto on_piece = [&](int x, int y) {
        return Vec2(middle + Vec2(x + 0.5 - sheet.width / 2.0, sheet.height / 2.0 - y - 0.5) / (1000.0 * dots));
    };
    int red = 0;
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x)
            if (sheet.is_red(x, y)) {
                ++red;
                // half of the line's width, half of a dot's diagonal, and the shift from rounding a page's size to
                // dots
                ASSERT_LT(distance_to_outline(piece.cut_line, on_piece(x, y)), 0.35e-3 / 2 + 0.2e-3 + 0.25e-3);
            }
    EXPECT_GT(red, testing::cut_length(piece) * 1000 * dots * 0.7) << "drawn through: a dot a column or row at least";
}

TEST(Pdf, WritesNamesWithTheirFonts) {
    RIPSTOP_REQUIRE_POPPLER();
    const PrintedFile file(pdf(testing::odd_pieces()));
    EXPECT_THAT(file.told_by("pdftotext -f 3 -l 3", "-"), HasSubstr("B\u00edl\u00fd \u0416\u03a9 <&>"));
    const std::string cover = file.told_by("pdftotext -layout -f 1 -l 1", "-");
    EXPECT_THAT(cover, HasSubstr("balloon.obj, revision B"));
    EXPECT_THAT(cover, HasSubstr("4 patterns on 5 pages; paper: roll"));
    EXPECT_TRUE(std::regex_search(cover, std::regex("2 +G01P01 +1 ?\u00d7 +524.0 \u00d7 364.0 mm"))) << cover;
    EXPECT_TRUE(std::regex_search(cover, std::regex("3 +B.* 2 \u00d7 and 3 \u00d7 turned over +424.0 \u00d7 224.0 mm")))
        << cover;
    EXPECT_TRUE(std::regex_search(file.told_by("pdffonts"), std::regex("DejaVuSans +TrueType +\\S+ +yes yes yes")));
    EXPECT_THAT(file.told_by("pdftotext -f 2 -l 2", "-"), HasSubstr("page 2 of 5"));
}

TEST(Pdf, AsksToBePrintedInTrueSizeAndKnowsNoDateButTheOneGiven) {
    const std::string bytes = pdf({testing::band("P", 0.5, 0.3)});
    EXPECT_THAT(bytes, HasSubstr("/ViewerPreferences << /PrintScaling /None >>"));
    EXPECT_THAT(bytes, Not(HasSubstr("Date")));
    RIPSTOP_REQUIRE_POPPLER();
    const PrintedFile file(bytes);
    const std::string info = file.told_by("pdfinfo");
    EXPECT_THAT(info, HasSubstr("Title:           balloon.obj, revision B"));
    EXPECT_THAT(info, HasSubstr("PDF version:     1.6"));
    EXPECT_THAT(file.told_by("pdfinfo -f 2 -l 2"), HasSubstr("Page    2 size:  1570.39 x 1003.46 pts"))
        << "524 x 324 mm, 3 mm round it and 12 mm margins: 554 x 354 mm";
    const PrintedFile dated(pdf({}, "roll", "2026-05-04"));
    EXPECT_THAT(dated.told_by("env TZ=UTC pdfinfo"), HasSubstr("CreationDate:    Mon May  4 12:00:00 2026 UTC"));
    EXPECT_THAT(dated.told_by("pdftotext", "-"), HasSubstr("balloon.obj, revision B, 2026-05-04"));
}

TEST(Pdf, GivesEqualPiecesOnePattern) {
    RIPSTOP_REQUIRE_POPPLER();
    std::vector<PatternPiece> pieces = testing::many_pieces(5);
    for (PatternPiece& piece : pieces) piece.quantity = 0;
    EXPECT_THAT(PrintedFile(pdf(pieces)).told_by("pdfinfo"), HasSubstr("Pages:           6\n"))
        << "asked for, so given";
    pieces[1].quantity = 5;
    const PrintedFile file(pdf(pieces));
    EXPECT_THAT(file.told_by("pdfinfo"), HasSubstr("Pages:           2\n"));
    EXPECT_THAT(file.told_by("pdftotext -f 1 -l 1", "-"), HasSubstr("4 more pieces are equal to some of these"));
}

TEST(Pdf, ListsAThousandPieces) {
    RIPSTOP_TOO_LONG_SANITIZED();
    RIPSTOP_REQUIRE_POPPLER();
    const PrintedFile file(pdf(testing::many_pieces(1000)));
    const std::string info = file.told_by("pdfinfo");
    const int covers = std::stoi(info.substr(info.find("Pages:") + 6)) - 1000;
    const std::string text = file.told_by("pdftotext -layout -f 1 -l " + std::to_string(covers), "-");
    for (const int piece : {1, 35, 36, 500, 1000})
        EXPECT_TRUE(std::regex_search(
            text, std::regex("\\b" + std::to_string(covers + piece) + " +P" + std::to_string(piece) + " +1")))
            << piece;
    EXPECT_THAT(file.told_by("pdftotext -f " + std::to_string(covers + 36) + " -l " + std::to_string(covers + 36), "-"),
                HasSubstr("P36"));
}

TEST(Pdf, RefusesTooManyPages) {
    const auto refusal = [](const std::vector<PatternPiece>& pieces, const std::string& paper) -> std::string {
        try {
            pdf(pieces, paper);
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(refusal(std::vector<PatternPiece>(30, testing::band("P", 40, 1.5)), "a4"),
                HasSubstr("the pieces take more than 20000 pages of A4; print them on larger paper"));
    EXPECT_THAT(refusal({}, "a9"), HasSubstr("no paper \"a9\""));
}

}  // namespace pdf_test
}  // namespace ripstop
