#include <algorithm>
#include <array>
#include <cmath>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/clip.h"
#include "ripstop/io/print/pdf_pages.h"

namespace ripstop {
namespace {

constexpr double cover_margin = 0.018;
constexpr double line_height = 0.0055;
constexpr double letter_height = 0.0024;
constexpr double head_height = 0.068;                                // space above the list on the first page
constexpr double joining = 0.026;                                    // space for the lines on how to join pages
constexpr double headings = 0.016;                                   // space above the list on the other pages
constexpr std::array<double, 4> columns = {0, 0.022, 0.075, 0.118};  // of the list, from cover_margin

std::string in_mm(double metres) {
    return format_fixed(metres / millimetre, 0);
}

bool has_joints(const PrintRun& run) {
    return std::any_of(run.pieces.begin(), run.pieces.end(), [](const PrintedPiece& p) { return p.map_page > 0; });
}

double above_list(const PrintRun& run, bool is_first) {
    return !is_first ? headings : head_height + (has_joints(run) ? joining : 0);
}

std::size_t rows_on(const PrintRun& run, bool is_first) {
    const double room = run.cover_size.y() - 2 * cover_margin - above_list(run, is_first);
    return static_cast<std::size_t>(std::floor(room / line_height));
}

std::string pages_text(const PrintedPiece& printed) {
    const std::string first = std::to_string(printed.first_page);
    return printed.map_page == 0 ? first : first + "-" + std::to_string(printed.last_page());
}

/// Writes a line at height `y` [m] above the lower edge, at most as wide as the page.
void write(PdfCanvas& canvas, const PrintRun& run, double y, const std::string& text, double height = letter_height) {
    canvas.text({text, Vec2(cover_margin, y), height, 0}, black, Align::left, run.cover_size.x() - 2 * cover_margin);
}

void draw_row(PdfCanvas& canvas, const PrintRun& run, double y, const std::array<std::string, 4>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double end = i + 1 < cells.size() ? columns[i + 1] : run.cover_size.x() - 2 * cover_margin;
        canvas.text({cells[i], Vec2(cover_margin + columns[i], y), letter_height, 0}, black, Align::left,
                    end - columns[i] - 0.002);
    }
}

/// Draws each kind of line beside its meaning.
void draw_legend(PdfCanvas& canvas, double y, bool with_matches) {
    std::vector<LineKind> kinds{cut_kind(), sew_kind(), grain_kind(), internal_kind()};
    if (with_matches) kinds.push_back(match_kind());
    constexpr double column = 0.085;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Vec2 at(cover_margin + column * static_cast<double>(i % 2), y - line_height * static_cast<double>(i / 2));
        canvas.line(at, at + Vec2(0.018, 0), kinds[i].ink);
        canvas.text({kinds[i].meaning, at + Vec2(0.021, 0), letter_height, 0}, black, Align::left, column - 0.023);
    }
}

void draw_head(PdfCanvas& canvas, const PrintRun& run) {
    double y = run.cover_size.y() - cover_margin - 0.004;
    const auto next = [&](const std::string& text) { write(canvas, run, y -= line_height, text); };
    write(canvas, run, y, run.title.empty() ? "Cut patterns" : run.title, 0.005);
    y -= 0.004;
    next(std::to_string(run.pieces.size()) + (run.pieces.size() == 1 ? " pattern on " : " patterns on ") +
         std::to_string(run.pages) + " pages; paper: " + run.paper + "; seen on the outside of the cloth");
    if (run.equal_pieces > 0)
        next(std::to_string(run.equal_pieces) + " more pieces are equal to some of these and counted there");
    y -= 0.003;
    next("1. Print at 100 %: no scaling, no fitting to the page, no borders taken off.");
    next("2. Measure the square on the first page you print: 100 mm; dashed, 4 in. Check the ruler on long ones.");
    next("    Where it is off, do not cut: the printer has scaled.");
    if (has_joints(run)) {
        next(
            "3. The map before a piece shows where its pages lie. Cut each page along its frame on the right and "
            "below.");
        next("    Lay these edges on the dotted lines of the next pages, so that the crosses in circles meet; glue.");
        next("    Check the whole: its size is in the list below.");
    }
    draw_legend(canvas, y -= 0.009, has_joints(run));
}

void draw_list(PdfCanvas& canvas, const PrintRun& run, double top, std::size_t from, std::size_t to) {
    draw_row(canvas, run, top, {"page", "piece", "cut", "size along the warp × across"});
    const double right = run.cover_size.x() - cover_margin;
    canvas.line({cover_margin, top - 0.0028}, {right, top - 0.0028}, {black, 0.0002});
    for (std::size_t i = from; i < to; ++i) {
        const PatternPiece& piece = *run.pieces[i].piece;
        const Vec2 size = piece.upper() - piece.lower();
        draw_row(
            canvas, run, top - line_height * static_cast<double>(i - from + 1),
            {pages_text(run.pieces[i]), piece.name, count_text(piece),
             format_fixed(size.x() / millimetre, 1) + " \u00d7 " + format_fixed(size.y() / millimetre, 1) + " mm"});
    }
}

}  // namespace

int cover_pages(const PrintRun& run) {
    const std::size_t first = rows_on(run, true), rows = rows_on(run, false);
    if (run.pieces.size() <= first) return 1;
    return 1 + static_cast<int>((run.pieces.size() - first + rows - 1) / rows);
}

void draw_cover(PdfCanvas& canvas, const PrintRun& run) {
    std::size_t from = 0;
    for (int page = 0; page < cover_pages(run); ++page) {
        const std::size_t to = std::min(run.pieces.size(), from + rows_on(run, page == 0));
        canvas.begin_page(run.cover_size, "cover " + std::to_string(page + 1));
        if (page == 0) {
            canvas.add_bookmark("Cover");
            draw_head(canvas, run);
        }
        draw_list(canvas, run, run.cover_size.y() - cover_margin - above_list(run, page == 0) + line_height, from, to);
        from = to;
    }
}

void draw_map(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed) {
    const PageGrid& grid = printed.grid;
    canvas.begin_page(run.cover_size, printed.piece->name + " map");
    canvas.add_bookmark(printed.piece->name);
    double y = run.cover_size.y() - cover_margin - 0.004;
    write(canvas, run, y, printed.piece->name, 0.005);
    write(canvas, run, y -= 0.010,
          (run.title.empty() ? "" : run.title + "; ") + count_text(*printed.piece) + "; " +
              std::to_string(grid.windows.size()) + " pages of " + in_mm(grid.page.x()) + " \u00d7 " +
              in_mm(grid.page.y()) + " mm, rows A, B, ... from top to bottom, with their numbers in this file");
    Vec2 lower = grid.windows.front().lower, upper = grid.windows.front().upper;
    for (const PageWindow& window : grid.windows) {
        lower = lower.cwiseMin(window.lower);
        upper = upper.cwiseMax(window.upper);
    }
    const Vec2 room(run.cover_size.x() - 2 * cover_margin, y - 0.008 - cover_margin);
    const double scale = (room.array() / (upper - lower).array()).minCoeff();
    const Vec2 origin = Vec2(cover_margin, y - 0.008) - scale * Vec2(lower.x(), upper.y());
    const auto at = [&](const Vec2& p) { return Vec2(origin + scale * p); };
    Points2 outline = closed_line(printed.piece->outline()) * scale;
    outline.rowwise() += origin.transpose();
    canvas.line(outline, cut_kind().ink);
    for (std::size_t i = 0; i < grid.windows.size(); ++i) {
        const PageWindow& window = grid.windows[i];
        canvas.rectangle(at(window.lower), at(window.upper), {{0.5, 0.5, 0.5}, 0.00015});
        const Vec2 middle = at((window.lower + window.upper) / 2), size = scale * (window.upper - window.lower);
        const double height = std::min(0.004, 0.2 * size.minCoeff());
        canvas.text({window.name(), middle + Vec2(0, 0.8 * height), height, 0}, black, Align::middle, 0.8 * size.x());
        canvas.text(
            {std::to_string(printed.first_page + static_cast<int>(i)), middle - Vec2(0, 0.8 * height), 0.7 * height, 0},
            black, Align::middle, 0.8 * size.x());
    }
}

}  // namespace ripstop
