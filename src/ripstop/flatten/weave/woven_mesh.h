#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct WovenOptions {
    double spacing = 0.5;            ///< yarn spacing, in mean edge lengths of the tile; > 0
    double warp_stiffness = 500;     ///< stiffness of the springs along the warp, as a ratio; > 0
    double weft_stiffness = 500;     ///< the same along the weft; > 0
    double diagonal_stiffness = 1;   ///< the same across the cells, the resistance to shear; > 0
    double energy_tolerance = 0.01;  ///< at rest if a sweep changes the energy by less than this fraction; > 0
    int max_iterations = 100;        ///< sweeps over all nodes; >= 0
};

/// Throws InputError if an option is out of range.
void require_valid(const WovenOptions& options);

/// Fits a woven mesh to the tile and reads the flat vertex positions off its yarns [WTY05, sections 3 and 4]: the
/// start for methods that refine a flattening.
///
/// The yarns through the tile's centre are straight lines on the surface, the warp along the tile's grain. The other
/// crossings are placed cell by cell along the cell's diagonal and relax under springs with the weave's own lengths
/// (warp, weft, diagonals), E = sum k (l - l0)^2 / 2, with l measured on the surface. As in the paper, the energy is
/// that on the surface, so the plane weave stays unstrained and its coordinates are the flattening. Two things differ
/// from the paper. Crossings relax one after the other by a Newton step (the paper: all at once, along the negative
/// gradient). A vertex takes the weighted mean over all crossings near it, each with the affine frame of its
/// neighbours (the paper: the nearest, eqs 9 and 10).
///
/// Exact on developable tiles. Elsewhere the boundary is free and yarns keep their length rather than their angle.
/// The result depends on the grain and, less, on the centre: the point nearest the area centroid, or one further
/// inside if that is close to the boundary.
///
/// Every vertex gets finite coordinates. Those that no crossing sees are laid on from their neighbours triangle by
/// triangle, all of them if the weave found no room. Flipped triangles are repaired where possible. `summary.reason`
/// counts all of these; a result with flipped triangles is usable but no start for a method that needs none. `fabric`
/// is ignored: the options give the stiffness ratio of the weave.
///
/// Requires a disk (`require_disk`). Throws InputError if the options are out of range. Cost: 10 to 20 ms per
/// thousand triangles, several times that if the surface is crumpled.
Flattening flatten_woven(const Tile& tile, const Fabric& fabric, const WovenOptions& options = {});

}  // namespace ripstop
