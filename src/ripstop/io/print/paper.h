#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// What a pattern is printed on.
struct Paper {
    std::string name;      ///< as it is called: `A4`, `roll`
    double width = 0;      ///< of a sheet, upright; on a roll the longest page [m]
    double height = 0;     ///< of a sheet; the widest page of a roll [m]
    bool is_roll = false;  ///< pages are as long and wide as what is on them

    /// Round what is drawn: printers do not print up to the edge, and the ruler stands there.
    static constexpr double margin = 0.012;
    /// What two pages side by side both show.
    static constexpr double overlap = 0.015;
};

/// `a4`, `a3`, `a2`, `a1`, `a0`, `letter`, `tabloid`; `roll`; or how wide the roll is, such as `914mm`. A page of a
/// roll is 5 m long at most: PDF ends at 200 in (5.08 m). Throws InputError naming the known ones.
Paper paper_named(const std::string& name);

/// The part of a piece that a page shows, in the piece's coordinates.
struct PageWindow {
    int column = 0, row = 0;  ///< from 0; row 0 is on top
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();

    std::string name() const;  ///< row and column: A1, A2, …, B1, …, AA1
};

/// The pages of a piece.
struct PageGrid {
    Vec2 page = Vec2::Zero();  ///< size of each [m]
    int columns = 1, rows = 1;
    std::vector<PageWindow> windows;  ///< row by row, without those on which nothing of the piece lies

    bool has(int column, int row) const;
};

/// How a piece is spread over pages, upright or lengthwise, whichever takes fewer. Windows side by side share
/// `Paper::overlap`; the piece lies in the middle of them. A page is left out where it shows nothing of the piece that
/// the pages left of and above it do not. Requires a piece with an outline. Throws InputError where there would be more
/// than `most_pages`. O(windows #V).
PageGrid make_page_grid(const PatternPiece& piece, const Paper& paper);
inline constexpr int most_pages = 20000;

}  // namespace ripstop
