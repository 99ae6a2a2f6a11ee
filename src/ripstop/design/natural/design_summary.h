#pragma once

#include "ripstop/design/natural/gores.h"
#include "ripstop/design/tools/tiles_summary.h"

namespace ripstop {

/// What a natural shape came out as: the tiles as drawn, beside the equilibrium they are drawn from.
struct DesignSummary : TilesSummary {
    int panels = 0;           ///< in a gore
    double diameter = 0;      ///< twice the greatest distance of a vertex from the axis [m]
    double panel_height = 0;  ///< along the meridian [m]
    double panel_width = 0;   ///< widest cloth across a gore [m]
    NaturalShape shape;
};

/// Measures the tiles that `design_natural(design)` gave. O(#F log #F).
DesignSummary measure_design(const EnvelopeDesign& design, const std::vector<NamedMesh>& tiles);

}  // namespace ripstop
