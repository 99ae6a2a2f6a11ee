#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// The text of report.html: one self-contained page that shows the plan in space and on the cloth. It holds `report`,
/// the text of report.json (`report_json` or more, preferably without `seconds`), and `page_shapes`. Both are deflated
/// [RFC 1950] and encoded in base64, so no tile name can act as markup. `strains`: one per tile
/// (`measure_strain_maps`), or empty. The same plan gives the same bytes.
///
/// Empty if the program was built without the page (`page_template`). About 0.6 MB, plus 2 kB per tile and 15 to 30
/// bytes per triangle; equal tiles take less. Throws std::runtime_error if there is not enough memory to deflate.
std::string html_report(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains, const std::string& report);

/// The parts of a page as they stand in it: title and summary escaped, the others deflated in base64.
struct PageParts {
    std::string title, summary;
    std::string report;  ///< report.json
    std::string shapes;  ///< `page_shapes`
    std::string roll;    ///< marker.json; empty before `nest`
};

/// The parts of a plan's page, without a roll. Parameters and errors are those of `html_report`.
PageParts page_parts(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                     const std::vector<StrainMap>& strains, const std::string& report);

/// Replaces the roll shown in the page. `marker_json`: the text of marker.json.
void set_roll(PageParts& page, const std::string& marker_json);

/// The text of the page. Empty if the program was built without the page.
std::string write_page(const PageParts& page);

/// The parts of a page written by this version's `write_page`; empty for any other text.
std::optional<PageParts> read_page(std::string_view text);

/// Encodes bytes in base64 [RFC 4648], padded, in one line.
std::string base64(std::string_view bytes);

}  // namespace ripstop
