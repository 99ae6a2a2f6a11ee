#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The paper that a pattern is printed on.
struct Paper {
    std::string name;      ///< `A4`, `roll`, …
    double width = 0;      ///< of a sheet, upright; for a roll, the longest page [m]
    double height = 0;     ///< of a sheet; for a roll, the widest page [m]
    bool is_roll = false;  ///< a page is as large as its contents

    /// Blank border of a page: printers do not print up to the edge, and the ruler needs room.
    static constexpr double margin = 0.012;
    /// Width of the strip that neighbouring pages both show.
    static constexpr double overlap = 0.015;
};

/// The paper with this name: `a4`, `a3`, `a2`, `a1`, `a0`, `letter`, `tabloid`, `roll`, or the width of a roll
/// such as `914mm`. A page of a roll is at most 5 m long, because PDF ends at 200 in (5.08 m). Throws InputError
/// that lists the known names.
Paper paper_named(const std::string& name);

/// The part of a piece that a page shows, in the piece's coordinates.
struct PageWindow {
    int column = 0, row = 0;  ///< from 0; row 0 is the top row
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();

    std::string name() const;  ///< row and column: A1, A2, …, B1, …, AA1
};

/// All pages of a piece.
struct PageGrid {
    Vec2 page = Vec2::Zero();  ///< size of a page [m]
    int columns = 1, rows = 1;
    std::vector<PageWindow> windows;  ///< row by row; windows without any part of the piece are left out

    bool has(int column, int row) const;
};

/// Divides a piece into pages, upright or landscape, whichever needs fewer. Neighbouring windows share
/// `Paper::overlap`; the piece is centred in them. A page is left out if it shows nothing of the piece that the
/// pages to the left and above do not show. Requires a piece with an outline. Throws InputError for more than
/// `most_pages` pages. O(windows #V).
PageGrid make_page_grid(const PatternPiece& piece, const Paper& paper);
inline constexpr int most_pages = 20000;

}  // namespace ripstop
