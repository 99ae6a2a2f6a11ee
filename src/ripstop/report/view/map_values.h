#pragma once

#include <Eigen/Core>
#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"
#include "ripstop/report/view/page_maps.h"

namespace ripstop {

/// What a map shows of each triangle of a tile (#F): strains and errors as ratios, shear [rad], deviation as the mean
/// of the corners [m], tension and stress [N/m], `ClothState` as a number. Not a number where the triangle is flipped
/// on the cloth. Empty where nothing is known of the tile. `strain`: of that tile, or empty.
Eigen::VectorXd cloth_values(const CutPlan& plan, std::size_t tile, const StrainMap& strain, const PageMap& map);

/// What a map shows of each boundary edge of each tile: its length error as a ratio; how far it is ahead of its mate at
/// its middle, by length along the seam, as a ratio of the seam's length; its seam tension, the largest force of its
/// load tape [N]. Not a number where nothing is known. Of an edge that belongs to two seams, the later one's. Empty for
/// a map of the cloth alone.
std::vector<Eigen::VectorXd> edge_values(const CutPlan& plan, const PageMap& map);

}  // namespace ripstop
