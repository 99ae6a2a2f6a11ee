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

/// Options of `write_directory` and `write_plan`: what they write and what they may replace.
struct WriteOptions {
    bool force = false;         ///< replace the contents of a directory that is not empty
    bool reproducible = false;  ///< leave `seconds` out of report.json, so every run writes the same bytes
    bool pictures = true;       ///< pictures/NAME.svg for each tile, and pictures/seams.svg
    bool png = false;           ///< also the PNG pictures of `write_png_pictures`
    int threads = 0;            ///< for the PNG pictures (0: one per core)
    std::vector<std::string> formats = {"dxf", "svg", "pdf"};  ///< formats of the cut files: names from `piece_formats`
    PieceFileOptions files = {};                               ///< options of the cut files
};

/// Writes the complete cut plan to the folder `dir`:
///
/// - report.json, and report.html (`html_report`) with the maps of `strains`
/// - tiles.csv, seams.csv and bom.csv
/// - flat/NAME.obj for each tile with flat positions, and flat/sewing.json if all tiles have them
/// - cut/ (`write_cut_files`) with pieces.json
/// - pictures/NAME.svg
/// - inflated/envelope.obj if the plan was inflated
///
/// NAME is the tile's `file` in report.json. A tile without flat positions has neither an OBJ nor a piece. The folder
/// is written completely or not at all, with the errors of `write_whole_directory`. `force` replaces an old plan; files
/// that belong to no plan are kept.
void write_directory(const std::filesystem::path& dir, const CutPlan& plan, const PieceSet& pieces,
                     const WriteOptions& options = {}, const std::vector<StrainMap>& strains = {});

}  // namespace ripstop
