#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// A colour map of report.html (apps/report/src/maps.js; a test holds both to the same words): what of the cloth's
/// triangles and of the edges is shown, as shares of what is allowed.
struct PageMap {
    std::string_view id;    ///< warp, weft, shear, area, edges, mismatch, tension
    std::string_view name;  ///< in words
    std::string_view negative = {}, positive = {};
    bool is_of_cloth = false, is_of_edges = false;
    bool is_unsigned = false;
};

/// Every map, in the page's order.
const std::vector<PageMap>& page_maps();

/// Those there is something to show of, by their ids; `edges` where there is nothing at all.
std::vector<std::string_view> maps_of(const CutPlan& plan, const std::vector<StrainMap>& strains);
const PageMap& page_map(std::string_view id);

/// The one the page opens with: seam mismatch where only seams fail, else the strain along the warp, else the first.
std::string_view first_map(const CutPlan& plan, const std::vector<StrainMap>& strains);

/// The place (`page_place`) of each triangle of a tile. `strain` without values: unknown.
std::vector<std::uint16_t> cloth_places(const CutPlan& plan, std::size_t tile, const StrainMap& strain,
                                        const PageMap& map);

/// The place of each boundary edge of each tile (#tiles, #boundary each); none for a map of the cloth alone. The
/// mismatch of an edge that belongs to two seams is the later one's.
std::vector<std::vector<std::uint16_t>> edge_places(const CutPlan& plan, const PageMap& map);

/// What stands beside the colours.
struct PageLegend {
    std::string low, high, note;
    bool is_pinned = true;  ///< to a tolerance, so that there is something beyond it
};
PageLegend page_legend(const CutPlan& plan, const PageMap& map);

}  // namespace ripstop
