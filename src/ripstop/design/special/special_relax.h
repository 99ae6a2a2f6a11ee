#pragma once

#include "ripstop/design/special/special_surface.h"

namespace ripstop {

/// Isotropic remeshing with edges about `edge` long: long edges are split, short ones collapsed, edges flipped and
/// vertices moved to the centre of their triangles (Botsch and Kobbelt 2004), each onto the body. Vertices on a curve
/// move along it only; vertices where curves meet and fixed ones do not move. No operation may leave a triangle that
/// is both poor and worse than before, so even degenerate slivers improve. `curves` are indexed by the surface's
/// half-edges. Linear in the number of triangles.
void relax(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge,
           int rounds);

/// Assigns poor triangles with two sides on a crease to the face across, which straightens a crease that zigzags.
/// Requires that no seams are cut yet.
void straighten_creases(WorkSurface& surface, const SpecialBody& body);

/// Splits every edge inside a tile from one of its seams to another, so that each corner wider than 35 degrees has an
/// edge into its tile; then smooths once more.
void relax_corners(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge);

/// The quality of a triangle: 1 if equilateral and facing outwards, 0 if degenerate, -1 if flipped:
///
///     4 sqrt(3) A . n / (sum of squared edge lengths), n the body's normal at its centroid.
double shape_quality(const SpecialBody& body, int face, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ripstop
