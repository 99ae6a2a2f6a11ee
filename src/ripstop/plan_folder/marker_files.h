#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// What a marker's files are called, without extension: `marker`, or `marker-FABRIC-COLOUR` where there are several.
std::vector<std::string> marker_stems(const Markers& markers);

/// What is drawn of a marker: its pieces as they lie, and first the parts of the roll, rectangles that are drawn, not
/// cut.
std::vector<PatternPiece> drawn_marker(const PieceSet& set, const Marker& marker);

/// Fills the folder with a file of each of `formats` (names of `piece_formats`; a PDF as `write_marker_pdf`) for each
/// marker, +x along the roll from its start, y from one edge of the cloth to the other, with marker.json and with
/// bom.csv. Throws InputError where a file cannot be written.
void write_marker_files(const std::filesystem::path& folder, const PieceSet& set, const Markers& markers,
                        const std::vector<std::string>& formats);

/// docs/marker.schema.json.
std::string marker_json(const PieceSet& set, const Markers& markers, const std::vector<std::string>& formats);

/// A table for a terminal: a line a marker, and a line a piece that could not be laid, then how many in all.
std::string marker_table(const Markers& markers);

}  // namespace ripstop
