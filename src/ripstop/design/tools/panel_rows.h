#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The number of edges of each row of a mesh, from the lowest row up. A row of n edges has n + 1 evenly spaced
/// vertices; a row of 0 edges is a point. Vertices are numbered along each row, row after row.
using RowColumns = std::vector<int>;

/// The desired number of edges across a panel at a row, as a real number.
struct RowWish {
    double across = 1;
    int least = 1;  ///< lower limit
};

/// The number of edges of each row of a panel, given those of its first and last row (its seams) and the wishes for
/// all rows. Consecutive rows differ by an odd number, so that triangles are staggered and the panel is its own
/// mirror image. Rows next to a seam have more edges than the seam, so that each corner has an edge into the panel.
/// Requires at least three rows, in a number that satisfies `parity_fits`.
RowColumns stagger(const std::vector<RowWish>& wishes, int first, int last);

/// Whether rows that alternate between odd and even can lead from a seam of `first` to a seam of `last` edges in
/// `strips` steps.
bool parity_fits(int first, int last, int strips);

/// The triangles between the rows, counter-clockwise if rows go up and vertices to the right. Symmetric about the
/// middle of the rows, provided that no two consecutive rows are both odd. With rows from `stagger` no interior edge
/// joins two boundary vertices.
Triangles triangulate_rows(const RowColumns& columns);

}  // namespace ripstop
