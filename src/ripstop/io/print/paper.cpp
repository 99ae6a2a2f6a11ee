#include "ripstop/io/print/paper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/text/lower_case.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/clip.h"
#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

constexpr double inch = 0.0254;
constexpr double longest_page = 5.0;  // PDF pages are at most 14,400 points, 5.08 m
constexpr double narrowest_roll = 0.2;
constexpr double air = 0.003;  // space around the piece for the width of its lines
// Every page has a header and the test square, so even the page of a small piece needs this size.
constexpr double smallest_window = 0.14;

const std::array sheets{Paper{"A4", 0.210, 0.297},
                        Paper{"A3", 0.297, 0.420},
                        Paper{"A2", 0.420, 0.594},
                        Paper{"A1", 0.594, 0.841},
                        Paper{"A0", 0.841, 1.189},
                        Paper{"Letter", 8.5 * inch, 11 * inch},
                        Paper{"Tabloid", 11 * inch, 17 * inch}};

/// The number of windows of size `room` that cover `extent`.
int windows_over(double extent, double room) {
    constexpr double rounding = 1e-9;
    const double count = std::ceil((extent - Paper::overlap) / (room - Paper::overlap) - rounding);
    return count < most_pages ? std::max(1, static_cast<int>(count)) : most_pages + 1;
}

/// True if the box contains any part of the piece, its inside included.
bool covers(const Points2& outline, const Vec2& lower, const Vec2& upper) {
    return contains(outline, Vec2((lower + upper) / 2)) || !clip_to_box(closed_line(outline), lower, upper).empty();
}

PageGrid grid_of(const PatternPiece& piece, const Vec2& lower, const Vec2& extent, const Vec2& room) {
    PageGrid grid;
    grid.page = room + Vec2::Constant(2 * Paper::margin);
    grid.columns = windows_over(extent.x(), room.x());
    grid.rows = windows_over(extent.y(), room.y());
    if (static_cast<double>(grid.columns) * grid.rows > most_pages)
        throw InputError("piece \"" + piece.name + "\" takes more than " + std::to_string(most_pages) +
                         " pages; print it on larger paper (--paper a0, --paper roll)");
    const Vec2 step = room - Vec2::Constant(Paper::overlap);
    const Vec2 whole = Vec2(step.x() * grid.columns, step.y() * grid.rows) + Vec2::Constant(Paper::overlap);
    const Vec2 first = lower - (whole - extent) / 2;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            PageWindow window{column, row, {}, {}};
            window.lower = first + Vec2(step.x() * column, step.y() * (grid.rows - 1 - row));
            window.upper = window.lower + room;
            // the parts shared with the pages to the left and above belong to those pages
            const Vec2 own_lower = window.lower + Vec2(column > 0 ? Paper::overlap : 0, 0);
            const Vec2 own_upper = window.upper - Vec2(0, row > 0 ? Paper::overlap : 0);
            if (covers(piece.outline(), own_lower, own_upper)) grid.windows.push_back(window);
        }
    return grid;
}

}  // namespace

Paper paper_named(const std::string& name) {
    const std::string lower = lower_case(name);
    const Paper roll{"roll", longest_page, longest_page, true};
    if (lower == "roll") return roll;
    std::string known = "roll";
    for (const Paper& sheet : sheets) {
        if (lower == lower_case(sheet.name)) return sheet;
        known += ", " + lower_case(sheet.name);
    }
    if (name.empty() || name.front() < '0' || name.front() > '9')
        throw InputError("no paper \"" + name + "\"; known: " + known + ", or the width of a roll, such as 914mm");
    Paper wide = roll;
    wide.height = parse_length(name, "--paper");
    if (!(wide.height >= narrowest_roll && wide.height <= longest_page))
        throw InputError("a roll of paper is 200 mm to 5 m wide, not " + name + "; give its width, such as 914mm");
    wide.name = "roll " + format_fixed(wide.height / millimetre, 0) + " mm wide";
    return wide;
}

std::string PageWindow::name() const {
    std::string letters;
    for (int n = row + 1; n > 0; n = (n - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (n - 1) % 26));
    return letters + std::to_string(column + 1);
}

bool PageGrid::has(int column, int row) const {
    const auto place = [](const PageWindow& window) { return std::pair(window.row, window.column); };
    const auto found = std::lower_bound(
        windows.begin(), windows.end(), std::pair(row, column),
        [&place](const PageWindow& window, const std::pair<int, int>& sought) { return place(window) < sought; });
    return found != windows.end() && place(*found) == std::pair(row, column);
}

PageGrid make_page_grid(const PatternPiece& piece, const Paper& paper) {
    const Vec2 lower = piece.lower() - Vec2::Constant(air);
    const Vec2 extent = piece.upper() + Vec2::Constant(air) - lower;
    const Vec2 largest = Vec2(paper.width, paper.height) - Vec2::Constant(2 * Paper::margin);
    if (!paper.is_roll) {
        PageGrid upright = grid_of(piece, lower, extent, largest);
        PageGrid lengthwise = grid_of(piece, lower, extent, {largest.y(), largest.x()});
        return lengthwise.windows.size() < upright.windows.size() ? lengthwise : upright;
    }
    Vec2 room;
    for (int axis = 0; axis < 2; ++axis) {
        const int count = windows_over(extent[axis], largest[axis]);
        room[axis] = std::max(smallest_window, (extent[axis] + (count - 1) * Paper::overlap) / count);
    }
    return grid_of(piece, lower, extent, room);
}

}  // namespace ripstop
