#pragma once

#include "ripstop/flatten/seam/seam_hold.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct SeamExactOptions {
    double bending = 1e-5;   ///< stiffness of the cut line, in A^1.5 E, >= 0: keeps it from folding into a zig-zag
    bool keep_area = false;  ///< hold the whole area too
    SeamStart start = SeamStart::boundary_first;
    int max_iterations = 60;  ///< of each Newton run, > 0
};

/// The cut shape of least cloth energy whose edges are exactly right.
///
/// Minimises the energy of the woven membrane (rest state the flat pattern, `WovenMembrane`) and a little bending of
/// the cut line over the flat positions, subject to the length of every boundary edge being the tile's own, with the
/// grain along +x. What must give goes into the cloth, where the fabric decides how. Exact on developable tiles.
///
/// From a conformal map with an isometric boundary, on large tiles by way of a coarse cloth (`coarse_solution`),
/// straight to Newton with the edges held (`SeamNewton`); where that fails, Newton with a free boundary from `start`
/// first; where that fails too, the edges are led from their free lengths to the true ones in steps. A converged result
/// holds every edge to 1e-11 of its length, has no triangle turned over and satisfies the first-order conditions;
/// `certificate` says so.
///
/// Requires a disk (`make_tile`). A few sparse factorisations of size 2 #V: one on a balloon panel, two or three on an
/// octant of a sphere.
Flattening flatten_seam_exact(const Tile& tile, const Fabric& fabric, const SeamExactOptions& options = {});

}  // namespace ripstop
