#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct WovenOptions {
    double spacing = 0.5;            ///< distance of the yarns, in mean edge lengths of the tile; > 0
    double warp_stiffness = 500;     ///< of the springs along the warp, a ratio to the others; > 0
    double weft_stiffness = 500;     ///< along the weft; > 0
    double diagonal_stiffness = 1;   ///< across the cells: what resists shear; > 0
    double energy_tolerance = 0.01;  ///< at rest when a sweep changes the energy by less than this part; > 0
    int max_iterations = 100;        ///< sweeps over all nodes; >= 0
};

/// Throws InputError where an option is out of range.
void require_valid(const WovenOptions& options);

/// Fits a woven mesh to the tile and reads off where its yarns put the tile's vertices [WTY05, section 3 and 4]: the
/// start for the methods that refine a flattening.
///
/// The yarns through the tile's centre are straight lines on the surface, warp along the tile's grain; the other
/// crossings are placed cell by cell, each at the cell's diagonal, and settle under springs of the weave's own lengths
/// (warp, weft, diagonals), E = sum k (l - l0)^2 / 2, l measured on the surface. As in the paper the energy lives on
/// the surface, so the plane weave stays unstrained and its coordinates are the flattening. Unlike it, crossings settle
/// one after the other by Newton's step (the paper: all at once, against the gradient), and a vertex takes the weighted
/// mean of what all crossings near it say, each with the affine frame of its neighbours (the paper: the nearest, eqs 9
/// and 10).
///
/// Exact on developable tiles. Elsewhere the boundary is free and yarns keep their length rather than their angle; the
/// result depends on the grain and, less, on the centre: the point nearest the area centre, or one further in where
/// that is close to the boundary.
///
/// Every vertex gets finite coordinates. Those that no crossing sees are laid on from their neighbours triangle by
/// triangle, all of them where the weave found no room; triangles that came out flipped are repaired where that goes.
/// `summary.reason` counts all of these; a result with flipped triangles left is usable but no start for a method that
/// needs none. `fabric` is not asked: the weave's ratio is the option's.
///
/// Requires a discrete disk (`require_disk`). Throws InputError for options out of range. Cost: 10 to 20 ms a thousand
/// triangles, several times that where the surface is crumpled.
Flattening flatten_woven(const Tile& tile, const Fabric& fabric, const WovenOptions& options = {});

}  // namespace ripstop
