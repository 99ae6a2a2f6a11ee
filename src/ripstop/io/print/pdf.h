#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// What is printed, and on what.
struct PrintOptions {
    std::string style = {};      ///< what the pieces belong to
    std::string revision = {};   ///< of the patterns
    std::string paper = "roll";  ///< as `paper_named` takes it
    std::string date = {};       ///< of their making, YYYY-MM-DD; none: none is stated
};

/// Writes the pieces as a PDF in true size, for paper templates.
///
/// First, on A4 (Letter with a Letter or Tabloid paper), a cover: how to print and to check the size, what the lines
/// mean, and which piece stands on which pages, in what size and how often it is cut. Then each piece by itself, its
/// warp along the page's width: on a roll one page as large as the piece, on sheets as many as it takes
/// (`make_page_grid`), before them a map of which page lies where. Pages of one piece overlap; a dashed line shows
/// where the neighbour's edge comes to lie, crosses in circles lie on each other. Every page has a frame, a ruler in
/// mm, a square of 100 mm and one of 4 in, the piece's name, the place on the map and the page's number. A piece of
/// quantity 0, which is cut by an equal one's pattern, is left out unless there are no others. Cut line and notches are
/// red, sew line (dashed), grain and internal lines blue, letters black with their fonts embedded. The same bytes on
/// every run with the same fonts.
///
/// Throws InputError for a paper that is not known and where there would be more than `most_pages` pages.
void write_pdf(std::ostream& out, const std::vector<PatternPiece>& pieces, const PrintOptions& options = {});

/// Throws InputError as `write_pdf` does, and draws nothing.
void require_printable(const std::vector<PatternPiece>& pieces, const std::string& paper);

}  // namespace ripstop
