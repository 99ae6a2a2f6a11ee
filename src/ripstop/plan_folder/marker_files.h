#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/piece/marker.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// The file name of a marker without extension: `marker`, or `marker-FABRIC-COLOUR` if there are several.
std::vector<std::string> marker_stems(const Markers& markers);

/// The drawing of a marker: first the parts of the roll, rectangles that are drawn but not cut, then its pieces in
/// place.
std::vector<PatternPiece> drawn_marker(const PieceSet& set, const Marker& marker);

/// Fills the folder with marker.json, bom.csv and, for each marker, a file in each of `formats` (names from
/// `piece_formats`; a PDF as `write_marker_pdf` writes it). +x runs along the roll from its start, y from one edge of
/// the cloth to the other. Throws InputError if a file cannot be written.
void write_marker_files(const std::filesystem::path& folder, const PieceSet& set, const Markers& markers,
                        const std::vector<std::string>& formats);

/// docs/marker.schema.json.
std::string marker_json(const PieceSet& set, const Markers& markers, const std::vector<std::string>& formats);

/// A table for a terminal: one line per marker and per piece that does not fit, then the totals.
std::string marker_table(const Markers& markers);

}  // namespace ripstop
