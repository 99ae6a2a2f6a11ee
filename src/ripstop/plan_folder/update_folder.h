#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"
#include "ripstop/plan_folder/unchanged.h"

namespace ripstop {

/// Writes the shape in flight: inflated/envelope.obj, in metres. Requires `plan.inflated`.
void write_inflated_shape(const std::filesystem::path& file, const CutPlan& plan);

/// Updates the folder of a plan that was inflated after `read_cut_plan`: rewrites report.json, report.html and
/// inflated/envelope.obj. The page keeps its roll. `read`: the contents of report.json when the plan was read. All or
/// nothing: throws InputError, and leaves the folder unchanged, if a file cannot be read or written or if another run
/// has changed the folder since. `reproducible` leaves the seconds out of report.json.
void write_inflated(const std::filesystem::path& folder, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                    const std::vector<StrainMap>& strains, const Unchanged& read, bool reproducible);

/// Shows the roll in the page of a plan's folder, from the text of marker.json. `read`: the contents of cut/pieces.json
/// when the pieces were read. A folder without a page is unchanged. Returns false, and leaves the page unchanged, if
/// another version wrote it. Throws as `write_inflated` does.
bool show_roll(const std::filesystem::path& folder, const std::string& marker_json, const Unchanged& read);

/// The text of report.json in a plan's folder. Throws InputError if it cannot be read.
std::string report_of(const std::filesystem::path& folder);

}  // namespace ripstop
