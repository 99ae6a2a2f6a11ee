#pragma once

#include "ripstop/design/special/special_body.h"
#include "ripstop/mesh/triangle_mesh.h"

namespace ripstop {

/// The body's surface by marching tetrahedra on a cubic grid, six to a cube round its diagonal (Kuhn): closed,
/// manifold, counter-clockwise from outside, its vertices near the surface (never nearer than a tenth of an edge to a
/// node, so that no triangle vanishes), its connection that of the grid's inner nodes. Throws InputError where the grid
/// would have more than 20 million nodes. Linear in their number.
TriangleMesh march(const SpecialBody& body, double step);

}  // namespace ripstop
