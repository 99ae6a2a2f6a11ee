#include "ripstop/io/print/pdf_pages.h"

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/clip.h"
#include "ripstop/io/text/sheet.h"

namespace ripstop {
namespace {

constexpr double page_margin = Paper::margin, overlap = Paper::overlap;
constexpr Colour grey = {0.5, 0.5, 0.5}, red = {0.8, 0, 0}, blue = {0, 0, 0.8};
constexpr Colour pale = {0.6, 0.6, 0.6};
constexpr double small_letters = 0.0022;

Points2 moved(Points2 points, const Vec2& shift) {
    points.rowwise() += shift.transpose();
    return points;
}

/// A window on a piece, drawn moved by `shift`.
class View {
  public:
    View(PdfCanvas& canvas, const PageWindow& window, const Vec2& shift)
        : canvas_(canvas), lower_(window.lower), upper_(window.upper), shift_(shift) {}

    void line(const Points2& points, const Ink& ink) const {
        for (const LinePart& part : clip_to_box(points, lower_, upper_))
            canvas_.line(moved(part.points, shift_), ink, part.from);
    }
    void text(Label label) const {
        const double reach = label.height * static_cast<double>(label.text.size());
        const Vec2 outside = (lower_ - label.middle).cwiseMax(label.middle - upper_);
        if (outside.maxCoeff() > reach) return;
        label.middle += shift_;
        canvas_.text(label, black);
    }

  private:
    PdfCanvas& canvas_;
    Vec2 lower_, upper_, shift_;
};

void draw_piece(const View& view, const PatternPiece& piece) {
    for (const DrawnLine& line : piece.lines) view.line(line.points, internal_kind().ink);
    if (piece.cut_line.rows() > 0) view.line(closed_line(piece.sew_line), sew_kind().ink);
    view.line(closed_line(piece.outline()), cut_kind().ink);
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits()) {
            Points2 slit(2, 2);
            slit << from.transpose(), to.transpose();
            view.line(slit, cut_kind().ink);
        }
    const Points2 arrow = grain_arrow(piece);
    if (arrow.rows() == 4) {
        Points2 head(3, 2);
        head << arrow.row(2), arrow.row(1), arrow.row(3);
        view.line(arrow.topRows(2), grain_kind().ink);
        view.line(head, grain_kind().ink);
    }
    for (const Label& label : piece.labels) view.text(label);
}

/// Draws a ruler along the lower edge, ticks outwards: each mm on the first 300, then each 10 mm.
void draw_ruler(PdfCanvas& canvas, const Vec2& from, double length) {
    constexpr int fine = 300;
    const int end = static_cast<int>(std::floor(length * 1000 + 1e-6));
    for (int mm = 0; mm <= end; mm += mm < fine ? 1 : 10) {
        const Vec2 at = from + Vec2(mm * 0.001, 0);
        const double tick = mm % 10 == 0 ? 0.0025 : mm % 5 == 0 ? 0.0018 : 0.001;
        canvas.line(at, at - Vec2(0, tick), {black, 0.0001});
        const bool is_numbered = mm > 0 && mm % (mm <= fine ? 10 : 100) == 0 && mm + 5 < end;
        if (is_numbered) canvas.text({std::to_string(mm / 10), at - Vec2(0, 0.0036), 0.0015, 0}, black);
    }
    canvas.text({"cm", from - Vec2(0, 0.0036), 0.0015, 0}, black, Align::left);
}

void draw_test_squares(PdfCanvas& canvas, const Vec2& lower) {
    constexpr double metric = Sheet::square_side, four_inches = 4 * 0.0254;
    canvas.rectangle(lower, lower + Vec2::Constant(metric), {pale, 0.0002});
    canvas.rectangle(lower, lower + Vec2::Constant(four_inches), {pale, 0.0002, {0.002, 0.002}});
    canvas.text({"100 mm", lower + Vec2(0.002, 0.0035), small_letters, 0}, pale, Align::left);
    canvas.text({"dashed: 4 in", lower + Vec2(metric - 0.002, 0.0035), small_letters, 0}, pale, Align::right);
}

/// Draws a cross in a circle, which must coincide with the neighbour's.
void draw_match_mark(PdfCanvas& canvas, const Vec2& at, const std::string& text) {
    const Ink ink{black, 0.0002};
    constexpr double radius = 0.003, arm = 0.005;
    canvas.circle(at, radius, ink);
    canvas.line(at - Vec2(arm, 0), at + Vec2(arm, 0), ink);
    canvas.line(at - Vec2(0, arm), at + Vec2(0, arm), ink);
    canvas.text({text, at + Vec2(0, 0.0066), 0.0018, 0}, grey, Align::middle, overlap);
}

std::string name_at(int column, int row) {
    return PageWindow{column, row, {}, {}}.name();
}

/// Draws what joins the page to its neighbours: crosses in the overlaps, and the lines of the neighbours' edges.
void draw_joints(PdfCanvas& canvas, const PageGrid& grid, const PageWindow& window) {
    const Vec2 lower(page_margin, page_margin), upper = grid.page - Vec2(page_margin, page_margin);
    const Vec2 size = upper - lower;
    const auto joint = [&](int column, int row) {  // from page (column, row) to the one right of it
        const double middle = column == window.column ? upper.x() - overlap / 2 : lower.x() + overlap / 2;
        for (const double share : {0.25, 0.75})
            draw_match_mark(canvas, {middle, lower.y() + share * size.y()},
                            name_at(column, row) + "|" + name_at(column + 1, row));
    };
    const auto joint_below = [&](int column, int row) {
        const double middle = row == window.row ? lower.y() + overlap / 2 : upper.y() - overlap / 2;
        for (const double share : {0.25, 0.75})
            draw_match_mark(canvas, {lower.x() + share * size.x(), middle},
                            name_at(column, row) + "|" + name_at(column, row + 1));
    };
    if (grid.has(window.column + 1, window.row)) joint(window.column, window.row);
    if (grid.has(window.column, window.row + 1)) joint_below(window.column, window.row);
    if (grid.has(window.column - 1, window.row)) {
        joint(window.column - 1, window.row);
        canvas.line({lower.x() + overlap, lower.y()}, {lower.x() + overlap, upper.y()}, match_kind().ink);
    }
    if (grid.has(window.column, window.row - 1)) {
        joint_below(window.column, window.row - 1);
        canvas.line({lower.x(), upper.y() - overlap}, {upper.x(), upper.y() - overlap}, match_kind().ink);
    }
}

std::string sheet_text(const PrintedPiece& printed, const PageWindow& window) {
    if (printed.map_page == 0) return "";
    return window.name() + " of " + std::to_string(printed.grid.rows) + " rows, " +
           std::to_string(printed.grid.columns) + " columns, map on page " + std::to_string(printed.map_page) + "; ";
}

void draw_header(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed, const PageWindow& window,
                 int page) {
    const double width = printed.grid.page.x() - 2 * page_margin, y = printed.grid.page.y() - page_margin + 0.0035;
    const std::string title = run.title.empty() ? "" : run.title + ": ";
    canvas.text(
        {title + printed.piece->name + ", " + count_text(*printed.piece), Vec2(page_margin, y), small_letters, 0},
        black, Align::left, 0.52 * width);
    canvas.text({sheet_text(printed, window) + "page " + std::to_string(page) + " of " + std::to_string(run.pages),
                 Vec2(page_margin + width, y), small_letters, 0},
                black, Align::right, 0.46 * width);
}

}  // namespace

LineKind cut_kind() {
    return {"cut: outline and notches", {red, 0.00035}};
}
LineKind sew_kind() {
    return {"sew line", {blue, 0.00025, {0.006, 0.002}}};
}
LineKind grain_kind() {
    return {"grain: the warp of the cloth", {blue, 0.00035}};
}
LineKind internal_kind() {
    return {"drawn on the piece, not cut", {blue, 0.00025, {0.006, 0.002, 0.001, 0.002}}};
}
LineKind match_kind() {
    return {"the edge of the page before lies here", {black, 0.0002, {0.001, 0.001}}};
}

std::string count_text(const PatternPiece& piece) {
    std::string text = std::to_string(piece.quantity) + " \u00d7";
    if (piece.quantity_mirrored > 0) text += " and " + std::to_string(piece.quantity_mirrored) + " \u00d7 turned over";
    return text;
}

void draw_page(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed, std::size_t window) {
    const PageGrid& grid = printed.grid;
    const PageWindow& shown = grid.windows[window];
    const int page = printed.first_page + static_cast<int>(window);
    canvas.begin_page(grid.page,
                      grid.windows.size() > 1 ? printed.piece->name + " " + shown.name() : printed.piece->name);
    if (window == 0 && printed.map_page == 0) canvas.add_bookmark(printed.piece->name);
    const Vec2 lower(page_margin, page_margin), upper = grid.page - lower;
    draw_test_squares(canvas, lower + Vec2::Constant(overlap + 0.005));
    canvas.begin_clip(lower, upper);
    draw_piece(View(canvas, shown, lower - shown.lower), *printed.piece);
    canvas.end_clip();
    draw_joints(canvas, grid, shown);
    canvas.rectangle(lower, upper, {grey, 0.00015});
    draw_ruler(canvas, lower, upper.x() - lower.x());
    draw_header(canvas, run, printed, shown, page);
    canvas.text({"True size: print at 100 %, not fitted to the page, and measure the square and the ruler.",
                 Vec2(page_margin, page_margin - 0.0068), 0.0018, 0},
                black, Align::left, upper.x() - lower.x());
}

}  // namespace ripstop
