#pragma once

#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Moves flat positions (#V x 2, no flipped triangle) close to the result of seam-exact flattening, at a cost that
/// hardly grows with the mesh: the coarse level of a coarse-to-fine solve.
///
/// The start u0 is deformed by a smooth displacement,
///
///     u(v) = u0(v) + sum_k N_k(u0(v)) c_k        N_k tensor products of cubic B-splines, some tens of cells over u0
///
/// whose few coefficients c minimise the energy of the woven membrane, sampled at some triangles of each cell. Stiff
/// springs hold the strain of sampled boundary edges and the rotation of the grain. The displacement is smooth, so it
/// transfers to the fine mesh without an interpolation error in the strains. The remaining error on the fine mesh is
/// of the order of the cell width to the third power.
///
/// Returns the start itself if the fit does not improve it or would flip a triangle. Dense Newton steps of a few
/// hundred unknowns, otherwise O(#V).
Points2 coarse_solution(const Tile& tile, const Fabric& fabric, const Points2& start);

}  // namespace ripstop
