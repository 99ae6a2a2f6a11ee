#pragma once

#include "ripstop/mesh/triangle_mesh.h"

/// Tiles that go all the way round and meet themselves: disks that are cut open along a line and sewn to
/// themselves there. Vertices on the two sides of the cut coincide. The meshes are exactly developable. Seen from
/// outside, in metres.
namespace ripstop::testing {

/// A tube over a polygon (counter-clockwise from above) with `columns` per side, cut along the edge at a corner.
TriangleMesh polygon_tube(const Points2& polygon, double height, int columns, int rows);
/// A tube over a regular polygon inscribed in a circle.
TriangleMesh round_tube(double radius, double height, int sides, int rows);
TriangleMesh box_tube(double width, double depth, double height, int columns, int rows);

/// A round tube cut open along a slanted line that moves by `slip` sides on its way up. On the cloth it is a
/// parallelogram whose upper edge is `slip` sides beside the lower one. Requires 0 < slip < sides.
TriangleMesh helical_tube(double radius, double height, int sides, int rows, int slip);

/// Bulges a tile around z by up to `share` of its distance from z, most at half its height; no longer developable.
TriangleMesh bulged(TriangleMesh mesh, double share);

}  // namespace ripstop::testing
