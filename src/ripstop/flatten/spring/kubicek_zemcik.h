#pragma once

#include "ripstop/flatten/spring/spring_mass.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The flattening of Kubicek and Zemcik [KZ]: a woven mesh is fitted to the tile (`flatten_woven`), then springs
/// along the edges of the tile's own mesh relax it (`relax_spring_mass`). Free boundary.
///
/// Exact on developable tiles. On curved ones the seams have the error of any free flattening: a gore of angle b is
/// b^2/24 too long along its edge. If triangles are still flipped at rest, the springs start again from Tutte's
/// embedding, which has no flips; the summary says so.
///
/// Requires a disk (`make_tile`). Some thousand passes over the edges.
Flattening flatten_kubicek_zemcik(const Tile& tile, const Fabric& fabric, const SpringMassOptions& options = {});

}  // namespace ripstop
