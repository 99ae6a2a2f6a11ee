#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/report/view/map_values.h"
#include "ripstop/report/view/page_maps.h"

namespace ripstop {

/// Where the colours of a map end, and the words beside them.
struct MapScale {
    std::string_view id;             ///< `there`: by what there is; `tolerance`: by what is allowed
    std::vector<double> cloth = {};  ///< of each tile: the value of full colour, in the unit of `cloth_values`
    double edges = 1;                ///< the same of every boundary edge
    bool has_beyond = false;         ///< what lies beyond has dark colours of its own; else it has those of the ends
    std::string low = {}, middle = {}, high = {}, note = {};
};

/// A map of a plan, for whoever paints it: the page has it in its data, the PNG pictures from here.
struct MapView {
    const PageMap* map = nullptr;
    std::vector<Eigen::VectorXd> cloth;  ///< `cloth_values` of each tile
    std::vector<Eigen::VectorXd> edges;  ///< `edge_values`
    std::vector<MapScale> scales;        ///< first the one it is shown in; of states one without ends
};

/// By what there is: so that all but 1 % of the triangles, and every edge, lie within; rounded up to 1, 2 or 5; not
/// less than a hundredth of what is allowed. The stresses of the cloth share one scale. By what is allowed: the
/// tolerance or the limit of the tile's fabric. It is shown by what is allowed where something lies beyond that, else
/// by what there is.
MapView map_view(const CutPlan& plan, const std::vector<StrainMap>& strains, const PageMap& map);

/// All that there is something to show of (`maps_of`), in that order.
std::vector<MapView> map_views(const CutPlan& plan, const std::vector<StrainMap>& strains);
const MapView& view_of(const std::vector<MapView>& views, std::string_view id);

/// The place (`page_place`) of each triangle of a tile, of each boundary edge of a tile, in a scale of the view.
std::vector<std::uint16_t> cloth_places(const CutPlan& plan, const MapView& view, std::size_t tile,
                                        std::size_t scale = 0);
std::vector<std::uint16_t> edge_places(const MapView& view, std::size_t tile, std::size_t scale = 0);

}  // namespace ripstop
