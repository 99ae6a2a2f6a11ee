#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Options of pattern files, and texts in them besides the pieces.
struct PieceFileOptions {
    std::string style = {};       ///< name of the style that the pieces belong to: the input's name
    std::string revision = {};    ///< of the patterns
    std::string dialect = "cam";  ///< for DXF: a name of `dxf_dialects`
    std::string date = {};        ///< of the patterns, YYYY-MM-DD; empty: no date is written
    std::string grain_axis = {};  ///< for DXF: x or y; empty: the dialect's default
    std::string paper = "roll";   ///< for PDF: as `paper_named` takes it
    double frame = 0;             ///< for HPGL: length of a frame [m]; 0: no frames
};

/// A file format for cutters, plotters or printers.
struct PieceFormat {
    std::string name;         ///< on the command line
    std::string extension;    ///< without the dot
    std::string description;  ///< one line for --help
    bool one_a_piece = true;  ///< write a file for each piece, besides the sheet of all pieces
    /// Writes the pieces, each moved by its shift [m]; without shifts they stay in place.
    void (*write)(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
                  const PieceFileOptions& options) = nullptr;
};

/// The table of formats for pieces, which the command line, `write_cut_files` and the tests iterate.
std::span<const PieceFormat> piece_formats();

/// The format with this name. Throws InputError that lists the known ones.
const PieceFormat& piece_format_named(const std::string& name);

}  // namespace ripstop
