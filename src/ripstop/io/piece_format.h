#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// What a pattern file says besides the pieces, and how.
struct PieceFileOptions {
    std::string style = {};       ///< what the pieces belong to: the input's name
    std::string revision = {};    ///< of the patterns
    std::string dialect = "cam";  ///< of a DXF: a name of `dxf_dialects`
    std::string date = {};        ///< of their making, YYYY-MM-DD; none: none is stated
    std::string grain_axis = {};  ///< of a DXF, x or y; none: as the dialect has it
    std::string paper = "roll";   ///< of a PDF: as `paper_named` takes it
    double frame = 0;             ///< of HPGL: length of a frame [m]; 0: all in one
};

/// A kind of file for cutters, plotters and printers.
struct PieceFormat {
    std::string name;         ///< as the command line knows it
    std::string extension;    ///< of its files, without the dot
    std::string description;  ///< a line for --help
    bool one_a_piece = true;  ///< besides the sheet of all pieces, a file for each
    /// Writes the pieces, each moved by its shift (metres; none: they stay where they are).
    void (*write)(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
                  const PieceFileOptions& options) = nullptr;
};

/// Every format pieces are written in; the command line, `write_cut_files` and the tests walk it.
std::span<const PieceFormat> piece_formats();

/// Throws InputError that names the known ones.
const PieceFormat& piece_format_named(const std::string& name);

}  // namespace ripstop
