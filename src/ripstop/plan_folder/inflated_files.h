#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// Puts an inflated plan that was read from `folder` (`read_cut_plan`) into it. report.json gets the key `inflated`,
/// that of each tile and the tapes of each seam, and keeps all else; report.html is written anew, with the roll where
/// there is one; inflated/envelope.obj has the tiles as they are in flight, in metres. Throws InputError where a file
/// cannot be read or written; the folder is then as before but for files already replaced as a whole.
void write_inflated(const std::filesystem::path& folder, const CutPlan& plan, const std::vector<StrainMap>& strains,
                    bool reproducible);

/// The text of report.json in a plan's folder. Throws InputError where it cannot be read.
std::string report_of(const std::filesystem::path& folder);

/// Only inflated/envelope.obj.
void write_inflated_shape(const std::filesystem::path& file, const CutPlan& plan);

}  // namespace ripstop
