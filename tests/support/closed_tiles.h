#pragma once

#include "ripstop/mesh/triangle_mesh.h"

/// Tiles that run all round and meet themselves: cut open along a line, sewn to themselves there. Disks whose vertices on
/// the two sides of the cut coincide; exactly developable as meshes. Seen from outside, in metres.
namespace ripstop::testing {

/// A tube over the corners of a polygon (counter-clockwise seen from above), `columns` a side, its cut along a corner's edge.
TriangleMesh polygon_tube(const Points2& polygon, double height, int columns, int rows);
/// A regular one, inscribed in a circle.
TriangleMesh round_tube(double radius, double height, int sides, int rows);
TriangleMesh box_tube(double width, double depth, double height, int columns, int rows);

/// A round tube cut open along a slanted line that goes `slip` sides round on its way up. On the cloth a parallelogram: the
/// upper edge lies `slip` sides beside the lower one. Requires 0 < slip < sides.
TriangleMesh helical_tube(double radius, double height, int sides, int rows, int slip);

/// Bows a tile that runs round z outward by up to `share` of its distance from z, most in the middle of its height: no
/// longer developable.
TriangleMesh bulged(TriangleMesh mesh, double share);

}  // namespace ripstop::testing
