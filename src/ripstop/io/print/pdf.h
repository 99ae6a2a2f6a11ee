#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Options of the printed pattern.
struct PrintOptions {
    std::string style = {};      ///< name of the style that the pieces belong to
    std::string revision = {};   ///< of the patterns
    std::string paper = "roll";  ///< as `paper_named` takes it
    std::string date = {};       ///< of the patterns, YYYY-MM-DD; empty: no date is written
};

/// Writes the pieces as a PDF at true size, for paper templates.
///
/// The cover comes first, on A4 (on Letter if the paper is Letter or Tabloid). It says how to print and how to
/// check the size, explains the lines, and lists for each piece its pages, its size and how often it is cut.
///
/// Then come the pieces, each with its warp along the page's width. On a roll, a piece is one page of its own
/// size. On sheets it takes as many pages as it needs (`make_page_grid`), after a map that shows where each page
/// goes. Pages of a piece overlap: a dashed line marks the neighbour's edge, and crosses in circles must coincide.
///
/// Every page has a frame, a ruler in mm, a square of 100 mm and one of 4 in, the piece's name, its place on the
/// map and its page number. A piece of quantity 0, which is cut by an equal piece's pattern, is left out unless
/// there are no others. Cut line and notches are red; sew line (dashed), grain and internal lines are blue;
/// letters are black, with embedded fonts. With the same fonts, every run writes the same bytes.
///
/// Throws InputError for an unknown paper and for more than `most_pages` pages.
void write_pdf(std::ostream& out, const std::vector<PatternPiece>& pieces, const PrintOptions& options = {});

/// Throws InputError if `write_pdf` would; draws nothing.
void require_printable(const std::vector<PatternPiece>& pieces, const std::string& paper);

}  // namespace ripstop
