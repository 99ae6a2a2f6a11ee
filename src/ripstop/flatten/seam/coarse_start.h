#pragma once

#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Brings flat positions (#V x 2, no triangle turned over) near to where seam-exact flattening ends, at a cost that
/// hardly grows with the mesh: the coarse half of coarse-to-fine.
///
/// The cloth is deformed by a smooth displacement of its start u0,
///
///     u(v) = u0(v) + sum_k N_k(u0(v)) c_k        N_k tensor products of cubic B-splines, some tens of cells over u0
///
/// whose few coefficients c minimise the energy of the woven membrane, taken on a sample of the triangles in each cell,
/// with the strain of a sample of the boundary edges and the turn of the grain held by stiff springs. The displacement
/// is smooth, so it carries over to the fine mesh without any interpolation error in its strains; what is left for the
/// fine mesh is of the order of the cells' width to the third power.
///
/// Returns the start itself where the fit does not make it better or would turn a triangle over. Dense Newton steps of
/// a few hundred unknowns; O(#V) beside.
Points2 coarse_solution(const Tile& tile, const Fabric& fabric, const Points2& start);

}  // namespace ripstop
