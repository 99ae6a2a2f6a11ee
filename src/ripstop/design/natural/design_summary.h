#pragma once

#include "ripstop/design/natural/gores.h"
#include "ripstop/design/tools/tiles_summary.h"

namespace ripstop {

/// The dimensions of a natural shape: its tiles as meshed, and the equilibrium they are based on.
struct DesignSummary : TilesSummary {
    int panels = 0;           ///< panels per gore
    double diameter = 0;      ///< twice the largest distance of a vertex from the axis [m]
    double panel_height = 0;  ///< height along the meridian [m]
    double panel_width = 0;   ///< largest width of cloth across a gore [m]
    NaturalShape shape;
};

/// Measures the tiles of `design_natural(design)`. O(#F log #F).
DesignSummary measure_design(const EnvelopeDesign& design, const std::vector<NamedMesh>& tiles);

}  // namespace ripstop
