#pragma once

#include <vector>

#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// A fill-reducing elimination order: the approximate minimum degree ordering [Amestoy, Davis, Duff 1996],
/// postordered, so children precede parents and subtrees are contiguous in the elimination tree.
///
/// Consecutive unknowns with the same neighbours, such as the x and y of a vertex, are ordered as one, which is
/// cheaper. About O(entries), deterministic.
std::vector<int> elimination_order(const SparsePattern& pattern);

/// One triangle of a pattern after its unknowns are renumbered, column by column with increasing rows.
struct OrderedTriangle {
    std::vector<int> column_start;  ///< size + 1
    std::vector<int> rows;
    std::vector<int> slots;  ///< index of each entry's value in the values of the original pattern
};

enum class Triangle { lower, upper };

/// The pattern after unknown `order[k]` is renumbered k. O(entries).
OrderedTriangle renumbered(const SparsePattern& pattern, const std::vector<int>& order, Triangle triangle);

}  // namespace ripstop
