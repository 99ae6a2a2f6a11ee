#pragma once

#include <Eigen/Core>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"
#include "ripstop/report/view/page_maps.h"

namespace ripstop {

/// The values of a map for each triangle of a tile (#F): strains and errors as ratios, shear [rad], deviation as the
/// mean of the corners [m], tension and stress [N/m], `ClothState` as a number. NaN if the triangle is flipped on the
/// cloth. Empty if there is no data for the tile. `strain`: of that tile, or empty.
Eigen::VectorXd cloth_values(const CutPlan& plan, std::size_t tile, const StrainMap& strain, const PageMap& map);

/// The values of a map for each boundary edge of each tile: its length error as a ratio; at its middle, the lead over
/// its mate by length along the seam, relative to the seam's length; its seam tension; the largest force of its load
/// tape [N]. NaN if unknown. An edge in two seams has the later one's value. Empty for a map of the cloth alone.
std::vector<Eigen::VectorXd> edge_values(const CutPlan& plan, const PageMap& map);

}  // namespace ripstop
