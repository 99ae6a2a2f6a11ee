#pragma once

#include <string>
#include <vector>

#include "ripstop/io/print/paper.h"
#include "ripstop/io/print/pdf_canvas.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A piece with its pages in the PDF, which are numbered from 1.
struct PrintedPiece {
    const PatternPiece* piece = nullptr;
    PageGrid grid = {};
    int map_page = 0;  ///< 0 where it is all on one page
    int first_page = 0;

    int last_page() const { return first_page + static_cast<int>(grid.windows.size()) - 1; }
};

/// What all pages have in common.
struct PrintRun {
    std::string title;                     ///< style and revision
    std::string paper;                     ///< its name
    Vec2 cover_size = Vec2(0.210, 0.297);  ///< of cover and maps
    std::vector<PrintedPiece> pieces = {};
    int equal_pieces = 0;  ///< left out, as they are cut by the pattern of an equal one
    int pages = 0;         ///< all of them
};

/// How a line of a piece is drawn; the cover explains it.
struct LineKind {
    std::string meaning;
    Ink ink;
};
LineKind cut_kind();
LineKind sew_kind();
LineKind grain_kind();
LineKind internal_kind();
LineKind match_kind();

/// How many pieces are cut by the pattern: `2 x`, `2 x and 2 x turned over`.
std::string count_text(const PatternPiece& piece);

/// How many pages the cover takes, and its drawing.
int cover_pages(const PrintRun& run);
void draw_cover(PdfCanvas& canvas, const PrintRun& run);

/// Where the pages of a piece lie.
void draw_map(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed);

/// A page of a piece: `window` of its grid.
void draw_page(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed, std::size_t window);

}  // namespace ripstop
