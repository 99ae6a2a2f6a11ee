#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The pieces of a plan with its fabrics and seam types, each once. A piece's files are called as its tile's `file` in
/// report.json. Throws InputError where a piece has the name of no tile.
PieceSet make_piece_set(const CutPlan& plan, std::vector<PatternPiece> pieces, const std::string& revision);

/// Fills the folder `cut`: for each of `formats` (names of `piece_formats`) envelope.EXT with all pieces on one sheet
/// (`lay_out`; in one row where HPGL is to have frames) and, where the format has them, tiles/NAME.EXT with each piece
/// at the origin. `options` are completed by what the set says of itself. Throws InputError where a file cannot be
/// written or a format is not known.
void write_cut_files(const std::filesystem::path& cut, const PieceSet& set, const std::vector<std::string>& formats,
                     PieceFileOptions options = {});

/// cut/pieces.json, and back. Throw InputError naming the file.
void write_pieces(const std::filesystem::path& file, const PieceSet& set);
PieceSet read_pieces_of(const std::filesystem::path& directory);

/// Shifts that put the pieces side by side on one sheet, as they are turned, in their order, in rows from top to
/// bottom. Bounding boxes are `gap` [m] apart; the sheet is `width` long (0: about square), or as the longest piece,
/// and its lower left corner the origin. For looking at and for cutters that nest by themselves, not a marker. A piece
/// without outline gets no shift.
std::vector<Vec2> lay_out(const std::vector<PatternPiece>& pieces, double gap, double width = 0);

}  // namespace ripstop
