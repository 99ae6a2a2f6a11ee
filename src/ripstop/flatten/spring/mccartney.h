#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct McCartneyOptions {
    bool woven = false;       ///< then settle under the orthotropic energy of the sequels
    double first_move = 0.1;  ///< of the trial moves, in mean edge lengths; > 0
    double last_move = 1e-5;  ///< at rest where not even moves as small as this lower the energy; in (0, first_move]
    int max_sweeps = 2000;    ///< over all vertices; >= 0
};

/// The flattening of McCartney, Hinds and Seow [MHS99]: triangles are laid down one by one, then vertices are moved by
/// trial, one after the other, where that lowers the energy.
///
///     E = sum_edges 1/2 (l - L)^2 / L        l on the cloth, L on the surface
///
/// A new vertex is laid where two circles meet, one that is there already goes to the mean of where it is and where
/// the new triangle would have it. The trial moves are (+-d, 0) and (0, +-d); the best one is taken, and where no
/// vertex finds one, d is halved. A move that would turn a triangle over is not tried. Exact on developable tiles,
/// where laying is. Isotropic, boundary free.
///
/// `woven`: the result then settles, by the same moves, under the energy of [MHS00, MHC05], the affine map of the
/// weave in each triangle, with the stiffness of `fabric` and the grain of the tile:
///
///     E = sum_triangles A'/2 (E_warp (S_warp - 1)^2 + E_weft (S_weft - 1)^2 + g phi^2)
///
/// S the stretch of the threads and phi their shear angle (`thread_strain`), A' the area on the cloth.
///
/// Energies are only compared, no force is ever formed, so rest is approached slowly; the limit of sweeps is said in
/// the summary. Requires a disk (`make_tile`). O(#V) a sweep. Throws InputError for options out of range.
Flattening flatten_mccartney(const Tile& tile, const Fabric& fabric, const McCartneyOptions& options = {});

}  // namespace ripstop
