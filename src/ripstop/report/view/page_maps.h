#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// A colour map of the page and of the PNG pictures: what of the cloth's triangles and of the boundary edges is shown.
struct PageMap {
    enum class Place { cloth, edges, both };
    std::string_view id;    ///< warp, weft, shear, area, edges, mismatch, tension, and those in flight
    std::string_view name;  ///< in words
    Place place = Place::cloth;
    std::string_view negative = {}, positive = {};  ///< what either sign means
    bool is_unsigned = false;
    bool is_in_flight = false;  ///< of the inflated envelope

    bool is_of_cloth() const { return place != Place::edges; }
    bool is_of_edges() const { return place != Place::cloth; }
    bool is_of_states() const { return id == "state"; }  ///< taut, wrinkled, slack: no figures
};

/// What cloth in flight can be, in the order of `ClothState`.
inline constexpr std::array<std::string_view, 3> cloth_states{"taut", "wrinkled", "slack"};

/// Every map, in the order in which it is offered.
const std::vector<PageMap>& page_maps();
const PageMap& page_map(std::string_view id);

/// Those there is something to show of, by their ids; `edges` where there is nothing at all.
std::vector<std::string_view> maps_of(const CutPlan& plan, const std::vector<StrainMap>& strains);

/// The one that is shown first: the deviation of an inflated envelope that can be made, seam mismatch where only seams
/// fail, else the strain along the warp, else the first there is.
std::string_view first_map(const CutPlan& plan, const std::vector<StrainMap>& strains);

}  // namespace ripstop
