#pragma once

#include "ripstop/flatten/spring/spring_mass.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The flattening of Kubicek and Zemcik [KZ]: a woven mesh is fitted to the tile (`flatten_woven`), then particles and
/// springs on the edges of the tile's own mesh bring it to rest (`relax_spring_mass`). The boundary is free.
///
/// Exact on developable tiles. On curved ones the seams come out as wrong as the geometry makes any free flattening: a
/// gore of angle b is b^2/24 too long round its edge. If triangles are still turned over at rest, the springs start
/// once more from Tutte's embedding, which has none; the summary says so.
///
/// Requires a disk (`make_tile`). Some thousand passes over the edges.
Flattening flatten_paper(const Tile& tile, const Fabric& fabric, const SpringMassOptions& options = {});

}  // namespace ripstop
