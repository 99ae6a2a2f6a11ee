#pragma once

#include "ripstop/design/special/special_body.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The body's surface by marching tetrahedra on a cubic grid, six per cube round its diagonal (Kuhn). It is closed,
/// manifold and counter-clockwise from outside, with vertices near the surface. They stay at least a tenth of an edge
/// from every node, so that no triangle degenerates. Its connectivity is that of the grid's inner nodes. Throws
/// InputError if the grid has more than 20 million nodes. Linear in their number.
TriangleMesh march(const SpecialBody& body, double step);

}  // namespace ripstop
