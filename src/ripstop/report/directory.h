#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/cut_plan.h"
#include "ripstop/model/pattern_piece.h"

namespace ripstop {

struct DirectoryOptions {
    bool force = false;         ///< replace what stands in a directory that is not empty
    bool reproducible = false;  ///< leave `seconds` out of report.json: the same bytes on every run
    bool pictures = true;       ///< pictures/NAME.svg, one a tile, and pictures/seams.svg
};

/// Writes the whole cut plan as `dir`: report.json, tiles.csv, seams.csv, flat/NAME.obj, cut/envelope.dxf and .svg with the pieces
/// shifted by `shifts` (`lay_out`), cut/tiles/NAME.dxf and .svg with each piece at the origin, pictures/NAME.svg. NAME is
/// the tile's `file` in report.json. Tiles without flat positions have no OBJ and, made by nobody, no piece.
///
/// All or nothing: everything is written beside as `dir.partial-PID` and renamed at the end; on failure it is removed and
/// `dir` is as before. Under `force` the old plan is replaced; files in it that no plan has are kept. Throws InputError
/// with path and reason: `dir` is not empty (without `force`) or no directory, its parent is missing or closed, the disk is
/// full.
void write_directory(const std::filesystem::path& dir, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                     const std::vector<Vec2>& shifts, const DirectoryOptions& options = {});

/// Throws InputError as `write_directory` would for what stands at `dir`, so that a long job can say so before it starts.
void require_writable(const std::filesystem::path& dir, bool force);

}  // namespace ripstop
