#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// A colour map of the page and of the PNG pictures: a quantity of the cloth's triangles, of the boundary edges, or
/// both.
struct PageMap {
    enum class Shown { cloth, edges, both };
    std::string_view id;    ///< warp, weft, shear, area, edges, mismatch, tension, and those in flight
    std::string_view name;  ///< title
    Shown shown = Shown::cloth;
    std::string_view negative = {}, positive = {};  ///< meaning of either sign
    bool is_unsigned = false;
    bool is_in_flight = false;  ///< of the inflated envelope

    bool is_of_cloth() const { return shown != Shown::edges; }
    bool is_of_edges() const { return shown != Shown::cloth; }
    bool is_of_states() const { return id == "state"; }  ///< values are taut, wrinkled and slack, not numbers
};

/// The names of the states of cloth in flight, in the order of `ClothState`.
inline constexpr std::array<std::string_view, 3> cloth_states{"taut", "wrinkled", "slack"};

/// All maps, in the order of the menu.
const std::vector<PageMap>& page_maps();
const PageMap& page_map(std::string_view id);

/// The maps with data, by id; `edges` if there is no data at all.
std::vector<std::string_view> maps_of(const CutPlan& plan, const std::vector<StrainMap>& strains);

/// The map that is shown first: the deviation of an inflated envelope that can be made; seam mismatch if only seams
/// fail; else the strain along the warp; else the first map.
std::string_view first_map(const CutPlan& plan, const std::vector<StrainMap>& strains);

}  // namespace ripstop
