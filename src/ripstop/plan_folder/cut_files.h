#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The pieces of a plan with its fabrics and seam types, each once. A piece's files are named after its tile's `file`
/// in report.json. Throws InputError if no tile has the name of a piece.
PieceSet make_piece_set(const CutPlan& plan, std::vector<PatternPiece> pieces, const std::string& revision);

/// Fills the folder `cut`. Each of `formats` (names from `piece_formats`) gives envelope.EXT with all pieces on one
/// sheet (`lay_out`; in one row if HPGL gets frames) and, if the format supports it, tiles/NAME.EXT with each piece at
/// the origin. The set's own information completes `options`. Throws InputError if a file cannot be written or a format
/// is unknown.
void write_cut_files(const std::filesystem::path& cut, const PieceSet& set, const std::vector<std::string>& formats,
                     PieceFileOptions options = {});

/// Writes and reads cut/pieces.json. Both throw InputError naming the file.
void write_pieces(const std::filesystem::path& file, const PieceSet& set);
PieceSet read_pieces_of(const std::filesystem::path& directory);

/// Shifts that lay the pieces side by side on one sheet, in order and in their orientation, in rows from top to bottom.
/// Bounding boxes are `gap` [m] apart. The sheet is `width` wide (0: roughly square), or as wide as the longest piece;
/// its lower left corner is the origin. The sheet is for viewing and for cutters with their own nesting; it is
/// not a marker. A piece without outline gets no shift.
std::vector<Vec2> lay_out(const std::vector<PatternPiece>& pieces, double gap, double width = 0);

}  // namespace ripstop
