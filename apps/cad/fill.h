#pragma once

#include "borders.h"

namespace ripstop::cad {

/// A triangulated face: the vertices of its border and inner ones.
struct Filled {
    std::vector<Vec3> inner = {};                    ///< [mm]
    std::vector<std::array<int, 3>> triangles = {};  ///< a vertex of the border, or -1 - i for the i-th inner one
};

/// Fills the border of a face with triangles of the given sizes, in the plane of u and v.
///
/// Triangulates the border with constraints. Then halves sides, the longest relative to its size first, and flips
/// sides after each step by Lawson's rule in the surface's metric. Sizes grow by at most half of the distance from
/// a finer border. At the end, each inner vertex moves to the centre of its neighbours unless that gives a bad
/// triangle. If the surface closes on itself, sides are halved until no two coincide in space. The number of
/// triangles is bounded by what the sizes ask for, on any surface, and by `most`, which only a border with more
/// pieces exceeds. Nothing if the border crosses itself in u and v.
std::optional<Filled> filled(const TopoDS_Face& face, const std::vector<BorderLoop>& loops,
                             const std::vector<Vec3>& points, const FaceSizes& sizes, double most);

}  // namespace ripstop::cad
