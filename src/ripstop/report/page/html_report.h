#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// The text of report.html: one page that shows the plan in space and on the cloth, with nothing to load from
/// elsewhere. It holds `report`, the text of report.json (`report_json` or more, best without `seconds`), and
/// `page_shapes`, each deflated [RFC 1950] in base64, so no name of a tile can be taken for markup. `strains`: one a
/// tile (`measure_strain_maps`), or none. The same bytes for the same plan.
///
/// Empty where the program was built without the page (`page_template`). About 0.6 MB, 2 kB a tile and 15 to 30 bytes a
/// triangle; equal tiles take less. Throws std::runtime_error where memory does not suffice to deflate.
std::string html_report(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains, const std::string& report);

/// The page with the roll shown in it: `marker_json` in the place of the one before, if any. A page without that place
/// is returned as it is.
std::string with_roll(const std::string& page, const std::string& marker_json);

/// Bytes in base64 [RFC 4648], padded, in one line.
std::string base64(std::string_view bytes);

}  // namespace ripstop
