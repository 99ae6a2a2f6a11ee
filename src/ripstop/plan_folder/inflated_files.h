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

/// Updates the folder of a plan that was inflated after `read_cut_plan`: report.json and report.html are written anew,
/// and inflated/envelope.obj. The page keeps its roll. `read`: what report.json held when the plan was read. All or
/// nothing: throws InputError where a file cannot be read or written or another run has changed the folder since, and
/// the folder is then as before. `reproducible` leaves out the seconds of report.json.
void write_inflated(const std::filesystem::path& folder, const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                    const std::vector<StrainMap>& strains, const Unchanged& read, bool reproducible);

/// Shows the roll in the page of a plan's folder, with the text of marker.json. `read`: what cut/pieces.json held when
/// the pieces were read. A folder without a page stays as it is. Returns false if another version wrote the page, which
/// then stays as it is. Errors as `write_inflated`.
bool show_roll(const std::filesystem::path& folder, const std::string& marker_json, const Unchanged& read);

/// The text of report.json in a plan's folder. Throws InputError where it cannot be read.
std::string report_of(const std::filesystem::path& folder);

}  // namespace ripstop
