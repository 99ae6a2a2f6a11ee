#pragma once

#include <vector>

#include "ripstop/numeric/sparse_pattern.h"

namespace ripstop {

/// The unknowns in the order in which to eliminate them, so that the factor stays sparse: the approximate minimum
/// degree ordering [Amestoy, Davis, Duff 1996], children before parents and subtree by subtree in the elimination tree.
///
/// Unknowns that follow each other and meet exactly the same unknowns, such as the x and y of a vertex, are ordered as
/// one, which is cheaper than one by one. About O(entries), deterministic.
std::vector<int> elimination_order(const SparsePattern& pattern);

/// One triangle of a pattern after its unknowns are renumbered, column by column, rows increasing.
struct OrderedTriangle {
    std::vector<int> column_start;  ///< size + 1
    std::vector<int> rows;
    std::vector<int> slots;  ///< where each entry's value lies in the values of the pattern it came from
};

enum class Triangle { lower, upper };

/// `order[k]` becomes number k. O(entries).
OrderedTriangle renumbered(const SparsePattern& pattern, const std::vector<int>& order, Triangle triangle);

}  // namespace ripstop
