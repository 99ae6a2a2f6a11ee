#pragma once

#include <string>
#include <vector>

#include "ripstop/io/print/paper.h"
#include "ripstop/io/print/pdf_canvas.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A piece and its pages in the PDF; pages are numbered from 1.
struct PrintedPiece {
    const PatternPiece* piece = nullptr;
    PageGrid grid = {};
    int map_page = 0;  ///< 0 if the piece fits on one page
    int first_page = 0;

    int last_page() const { return first_page + static_cast<int>(grid.windows.size()) - 1; }
};

/// Properties that all pages share.
struct PrintRun {
    std::string title;                     ///< style and revision
    std::string paper;                     ///< its name
    Vec2 cover_size = Vec2(0.210, 0.297);  ///< of cover and maps
    std::vector<PrintedPiece> pieces = {};
    int equal_pieces = 0;  ///< number of pieces left out because an equal piece's pattern cuts them
    int pages = 0;         ///< number of all pages
};

/// How a kind of line is drawn; the cover explains it.
struct LineKind {
    std::string meaning;
    Ink ink;
};
LineKind cut_kind();
LineKind sew_kind();
LineKind grain_kind();
LineKind internal_kind();
LineKind match_kind();

/// How many pieces the pattern cuts: `2 x`, `2 x and 2 x turned over`.
std::string count_text(const PatternPiece& piece);

/// The number of cover pages; `draw_cover` draws them.
int cover_pages(const PrintRun& run);
void draw_cover(PdfCanvas& canvas, const PrintRun& run);

/// Draws the map of a piece's pages.
void draw_map(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed);

/// Draws the page of a piece that shows the grid's window with this index.
void draw_page(PdfCanvas& canvas, const PrintRun& run, const PrintedPiece& printed, std::size_t window);

}  // namespace ripstop
