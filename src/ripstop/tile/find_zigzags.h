#pragma once

#include <vector>

#include "ripstop/geometry/fair_curve.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/zigzag.h"

namespace ripstop {

/// Finds the zigzags of each tile, in the order of the tiles and their boundaries.
///
/// A run lies between consecutive changes of neighbour and given corners. It has turns of more than 6 degrees within
/// the surface, at most six edges apart. At least four of them and at least 11 in 20 change side, the teeth are at
/// most a quarter as high as the run is large, and its fair curve (`FairCurve`) stays within an edge of it. This
/// excludes corners, coarse curves, and hems whose scallops are many edges wide. O(#boundary).
std::vector<Zigzag> find_zigzags(const std::vector<const Tile*>& tiles, const std::vector<Seam>& seams);
std::vector<Zigzag> find_zigzags(const std::vector<Tile>& tiles, const std::vector<Seam>& seams);

/// The layout of the zigzag on the surface; `turning` is that of its tile's boundary (`surface_turning`).
ChainLayout layout_of(const Zigzag& zigzag, const Tile& tile, const Eigen::VectorXd& turning);

}  // namespace ripstop
