#pragma once

#include <vector>

#include "ripstop/model/special/special_shape.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// The tiles of a special shape. Each is a disk, named by primitive, sector and ring (`BODY-S03R02`,
/// docs/special.md), sorted by these, counter-clockwise from outside. Together they are closed except for the mouth:
/// on a seam both tiles have vertices at the same places, bit for bit. Every vertex lies on the shape to 1e-9 m, so
/// volume and area have an error of O(edge length^2). The same shape gives the same bits on any number of threads.
///
/// Marching tetrahedra give a first surface. It is cut along creases (where the levels of two primitives are equal),
/// sector planes, ring planes and the mouth, and remeshed between these curves with edges of `edge_length`. A piece
/// smaller than a twentieth of the median tile is merged with its neighbour.
///
/// Throws InputError (`require_valid`; a primitive that is separate from the others or entirely inside them; a
/// cavity; a mouth that misses the body or cuts it more than once; a tile that is not a disk because seams are
/// missing; a seam that cannot be followed; a grid of more than 20 million nodes). Linear in the volume of the box
/// over the cube of the edge length.
std::vector<NamedMesh> design_special(const SpecialShape& shape);

}  // namespace ripstop
