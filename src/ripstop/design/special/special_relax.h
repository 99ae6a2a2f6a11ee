#pragma once

#include "ripstop/design/special/special_surface.h"

namespace ripstop {

/// Makes the triangles even, with edges about `edge` long: long edges are split, short ones collapsed, edges flipped
/// and vertices moved to the middle of their triangles (Botsch and Kobbelt 2004), each new place on the body. Vertices
/// on a curve move along it only, where curves meet they stay, and so do fixed ones. Nothing is done that leaves a
/// triangle both poor and worse than before, so even slivers of no area mend. `curves` holds what the surface's
/// half-edges count. Linear in the number of triangles.
void relax(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge,
           int rounds);

/// Gives poor triangles that two sides of a crease meet in to the face across: a crease that runs to and fro gets
/// straight. Requires that no seams are cut yet.
void straighten_creases(WorkSurface& surface, const SpecialBody& body);

/// Splits every edge that runs inside a tile from one of its seams to another, so that each corner wider than 35
/// degrees has an edge into its tile; then moves once more.
void relax_corners(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge);

/// 1 for an equilateral triangle that faces outwards, 0 for one of no area, -1 for one turned over:
///
///     4 sqrt(3) A . n / (sum of squared edge lengths), n the body's normal in its middle.
double shape_quality(const SpecialBody& body, int face, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ripstop
