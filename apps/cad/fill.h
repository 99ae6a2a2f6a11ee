#pragma once

#include "borders.h"

namespace ripstop::cad {

/// A face in triangles: the vertices of its border and others within it.
struct Filled {
    std::vector<Vec3> inner = {};                    ///< [mm]
    std::vector<std::array<int, 3>> triangles = {};  ///< a vertex of the border, or -1 - i for the i-th within
};

/// Fills the border of a face with triangles of the sizes asked for, in the plane of u and v.
///
/// A constrained triangulation of the border, whose sides are then halved, the longest for its size first, and flipped
/// after each by Lawson's rule in the surface's metric; sizes grow by half of the distance from a finer border at
/// most. At the end the inner vertices go to the middle of their neighbours where that makes no bad triangle. Where the
/// surface closes on itself sides are halved until no two of them are the same in space. The triangles are bounded by
/// what the sizes ask for, whatever the surface, and by `most`, which only a border of more pieces exceeds. Nothing
/// where the border crosses itself in u and v.
std::optional<Filled> filled(const TopoDS_Face& face, const std::vector<BorderLoop>& loops,
                             const std::vector<Vec3>& points, const FaceSizes& sizes, double most);

}  // namespace ripstop::cad
