#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// How many edges each row of a mesh has, from its lowest row up. A row of n edges has n + 1 vertices evenly spaced
/// over its width; a row of none is a point. Vertices are numbered along each row, row after row.
using RowColumns = std::vector<int>;

/// How finely a panel is divided: the wanted number of edges across, as a real number, at each row.
struct RowWish {
    double across = 1;
    int least = 1;  ///< never fewer than this
};

/// Counts for the rows of a panel, given those of its first and last row (its seams) and wishes for all rows.
/// Neighbouring rows differ by an odd number, so that triangles stand staggered and the panel is its own mirror image;
/// rows next to a seam have more edges than the seam, so that each corner has an edge into the panel. Requires at least
/// three rows, in a number for which `parity_fits`.
RowColumns stagger(const std::vector<RowWish>& wishes, int first, int last);

/// Whether rows that alternate between odd and even can run from a seam of `first` to a seam of `last` edges in
/// `strips` steps.
bool parity_fits(int first, int last, int strips);

/// The triangles between the rows, counter-clockwise where rows go up and vertices to the right. Symmetric about the
/// middle of the rows, provided no two neighbouring rows are both odd. No edge inside joins two boundary vertices,
/// given rows from `stagger`.
Triangles triangulate_rows(const RowColumns& columns);

}  // namespace ripstop
