#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct McCartneyOptions {
    bool woven = false;       ///< then relax under the orthotropic energy of the later papers
    double first_move = 0.1;  ///< initial trial move, in mean edge lengths; > 0
    double last_move = 1e-5;  ///< at rest if moves as small as this do not lower the energy; in (0, first_move]
    int max_sweeps = 2000;    ///< sweeps over all vertices; >= 0
};

/// The flattening of McCartney, Hinds and Seow [MHS99]: triangles are laid one by one, then vertices are moved by
/// trial, one after the other, if that lowers the energy.
///
///     E = sum_edges 1/2 (l - L)^2 / L        l on the cloth, L on the surface
///
/// A new vertex is placed where two circles meet; an existing one moves to the mean of its place and the place that
/// the new triangle wants. The trial moves are (+-d, 0) and (0, +-d); the best is taken, and d is halved when no
/// vertex improves. A move that would flip a triangle is not tried. Exact on developable tiles, because laying is.
/// Isotropic, free boundary.
///
/// With `woven`, the same moves then relax the result under the energy of [MHS00, MHC05], based on the affine map of
/// the weave in each triangle, with the stiffness of `fabric` and the grain of the tile:
///
///     E = sum_triangles A'/2 (E_warp (S_warp - 1)^2 + E_weft (S_weft - 1)^2 + g phi^2)
///
/// where S is the stretch of the threads, phi their shear angle (`thread_strain`) and A' the area on the cloth.
///
/// The method only compares energies and never computes a force, so it converges slowly; the summary reports a
/// reached sweep limit. Requires a disk (`make_tile`). O(#V) per sweep. Throws InputError if the options are out of
/// range.
Flattening flatten_mccartney(const Tile& tile, const Fabric& fabric, const McCartneyOptions& options = {});

}  // namespace ripstop
