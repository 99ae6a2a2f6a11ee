#pragma once

#include <optional>
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

/// The parts of a page, as texts that stand in it: title and summary escaped, the others deflated in base64.
struct PageParts {
    std::string title, summary;
    std::string report;  ///< report.json
    std::string shapes;  ///< `page_shapes`
    std::string roll;    ///< marker.json; empty before `nest`
};

/// The parts of the page of a plan, without a roll. Parameters and errors are those of `html_report`.
PageParts page_parts(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                     const std::vector<StrainMap>& strains, const std::string& report);

/// Replaces the roll that the page shows. `marker_json`: the text of marker.json.
void set_roll(PageParts& page, const std::string& marker_json);

/// The text of the page. Empty where the program was built without the page.
std::string write_page(const PageParts& page);

/// The parts of a page that `write_page` of this version wrote; nothing for any other text.
std::optional<PageParts> read_page(std::string_view text);

/// Bytes in base64 [RFC 4648], padded, in one line.
std::string base64(std::string_view bytes);

}  // namespace ripstop
