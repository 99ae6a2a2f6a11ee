#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"
#include "ripstop/plan_folder/whole_directory.h"

namespace ripstop {

/// What `write_directory` writes and what it may replace.
struct DirectoryOptions {
    bool force = false;                      ///< replace what stands in a directory that is not empty
    bool reproducible = false;               ///< leave `seconds` out of report.json: the same bytes on every run
    bool pictures = true;                    ///< pictures/NAME.svg, one a tile, and pictures/seams.svg
    bool png = false;                        ///< beside them the PNG pictures of `write_png_pictures`
    int threads = 0;                         ///< to make these (0: one a core)
    std::vector<std::string> warnings = {};  ///< of what is left out, after those of the plan
    std::vector<std::string> formats = {"dxf", "svg", "pdf"};  ///< of the cut files: names of `piece_formats`
    PieceFileOptions files = {};                               ///< how they are written
};

/// Writes the whole cut plan to the folder `dir`:
///
/// - report.json, and report.html (`html_report`) with the maps of `strains`
/// - tiles.csv, seams.csv and bom.csv
/// - flat/NAME.obj for each tile that has flat positions, and flat/sewing.json if all have them
/// - cut/ (`write_cut_files`) with pieces.json
/// - pictures/NAME.svg
/// - inflated/envelope.obj if the plan was inflated
///
/// NAME is the tile's `file` in report.json. A tile without flat positions has neither OBJ nor piece. The folder is
/// written whole or not at all, and errors are those of `write_whole_directory`. With `force` the old plan is replaced;
/// files that belong to no plan are kept.
void write_directory(const std::filesystem::path& dir, const CutPlan& plan, const PieceSet& pieces,
                     const DirectoryOptions& options = {}, const std::vector<StrainMap>& strains = {});

}  // namespace ripstop
