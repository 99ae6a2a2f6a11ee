#pragma once

#include "ripstop/flatten/seam/seam_hold.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct SeamExactOptions {
    double bending = 1e-5;   ///< stiffness of the cut line, in A^1.5 E, >= 0: prevents zigzag folding
    bool keep_area = false;  ///< also keep the total area
    SeamStart start = SeamStart::boundary_first;
    int max_iterations = 60;  ///< per Newton run, > 0
};

/// The cut shape of least cloth energy with exact edge lengths.
///
/// Minimises the energy of the woven membrane (rest state: the flat pattern, `WovenMembrane`) plus a small bending
/// energy of the cut line over the flat positions. Every boundary edge keeps the tile's own length, and the grain
/// lies along +x. All deformation goes into the cloth, distributed as the fabric prefers. Exact on developable tiles.
///
/// Newton's method with fixed edge lengths (`SeamNewton`) starts from a conformal map with an isometric boundary, on
/// large tiles improved by a coarse solve (`coarse_solution`). If it fails, Newton with a free boundary runs first,
/// from `start`. If that fails too, continuation from the free to the true edge lengths is tried. A converged
/// result holds every edge to 1e-11 of its length, has no flipped triangle and satisfies the first-order conditions;
/// `certificate` proves it.
///
/// Requires a disk (`make_tile`). A few sparse factorisations of size 2 #V: one for a balloon panel, two or three for
/// an octant of a sphere.
Flattening flatten_seam_exact(const Tile& tile, const Fabric& fabric, const SeamExactOptions& options = {});

}  // namespace ripstop
