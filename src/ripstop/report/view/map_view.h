#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/report/view/map_values.h"
#include "ripstop/report/view/page_maps.h"

namespace ripstop {

/// The end values of a map's colours, with the words of the legend.
struct MapScale {
    std::string_view id;             ///< `there`: from the values; `tolerance`: from the limits
    std::vector<double> cloth = {};  ///< per tile: the value of full colour, in the unit of `cloth_values`
    double edges = 1;                ///< likewise for every boundary edge
    bool has_beyond = false;         ///< values beyond have dark colours; else those of the ends
    std::string low = {}, middle = {}, high = {}, note = {};
};

/// A map of a plan. The page has it in its data, and the PNG pictures are painted from it.
struct MapView {
    const PageMap* map = nullptr;
    std::vector<Eigen::VectorXd> cloth;  ///< `cloth_values` of each tile
    std::vector<Eigen::VectorXd> edges;  ///< `edge_values`
    std::vector<MapScale> scales;        ///< the first is shown first; state maps have one scale without ends
};

/// The scale `there` includes all but 1 % of the triangles and every edge, rounded up to 1, 2 or 5, and at least a
/// hundredth of the limit. The stresses of the cloth share one scale. The scale `tolerance` ends at the tolerance or at
/// the limit of the tile's fabric. It comes first if a value exceeds it; otherwise `there` does.
MapView map_view(const CutPlan& plan, const std::vector<StrainMap>& strains, const PageMap& map);

/// All maps with data (`maps_of`), in that order.
std::vector<MapView> map_views(const CutPlan& plan, const std::vector<StrainMap>& strains);
const MapView& view_of(const std::vector<MapView>& views, std::string_view id);

/// The colour (`page_place`) of each triangle or each boundary edge of a tile, in a scale of the view.
std::vector<std::uint16_t> cloth_places(const CutPlan& plan, const MapView& view, std::size_t tile,
                                        std::size_t scale = 0);
std::vector<std::uint16_t> edge_places(const MapView& view, std::size_t tile, std::size_t scale = 0);

}  // namespace ripstop
