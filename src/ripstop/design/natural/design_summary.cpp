#include "ripstop/design/natural/design_summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {

DesignSummary measure_design(const EnvelopeDesign& design, const std::vector<NamedMesh>& tiles) {
    DesignSummary summary{measure_tiles(tiles), 0, 0, 0, 0, {}};
    summary.shape = design_shape(design);
    summary.panels = summary.tiles / design.gores;
    for (const NamedMesh& tile : tiles)
        summary.diameter =
            std::max(summary.diameter, 2 * tile.mesh.positions.leftCols<2>().rowwise().norm().maxCoeff());
    const double a = std::numbers::pi / design.gores;
    const double bulge = design.bulge;
    summary.panel_width = 2 * summary.shape.max_radius * (bulge > 0 ? std::sin(a) * bulge / std::sin(bulge) : a);
    const double top =
        design.crown_radius > 0 ? summary.shape.meridian.descent_to(design.crown_radius).s : summary.shape.length;
    summary.panel_height = top / summary.panels;
    return summary;
}

}  // namespace ripstop
