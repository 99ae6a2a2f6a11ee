#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "ripstop/base/index.h"

namespace ripstop {

/// Lists which unknowns of a symmetric system are coupled, group by group. Groups are numbered in order of insertion.
struct Couplings {
    /// Adds an element: all its unknowns are coupled with each other. Its entries are the element's own lower
    /// triangle row by row: entry (a, b), a >= b, has number a (a + 1) / 2 + b. Requires distinct unknowns.
    int add_element(std::span<const int> unknowns);

    /// Adds a row, such as a constraint's: `row` is coupled with itself (entry 0) and with each of `columns` (entry 1
    /// + j), but the columns are not coupled with each other. Requires distinct unknowns.
    int add_row(int row, std::span<const int> columns);

    int count() const { return static_cast<int>(is_row.size()); }

    std::vector<int> start = {
        0};  ///< group g is unknowns[start[g]] … unknowns[start[g + 1] - 1]; a row has `row` first
    std::vector<int> unknowns;
    std::vector<char> is_row;
};

/// The sparsity pattern of a symmetric matrix: its lower triangle, column by column with increasing rows, the whole
/// diagonal included. It is built once; every assembly is then
///
///     values.setZero();
///     for each group g:  for each entry k:  values[pattern.slots(g)[k]] += ...
///
/// without a search or a sort, and with a fixed order of the sums. Building takes O(entries of all groups).
class SparsePattern {
  public:
    SparsePattern(int size, const Couplings& couplings);

    int size() const { return static_cast<int>(column_start_.size()) - 1; }
    int entry_count() const { return static_cast<int>(rows_.size()); }

    /// The index of each entry of a group in the values, in the group's own order.
    std::span<const int> slots(int group) const {
        const auto g = static_cast<std::size_t>(group);
        return {slots_.data() + slot_start_[g], slots_.data() + slot_start_[g + 1]};
    }
    int diagonal_slot(int unknown) const { return column_start_[at(unknown)]; }

    const std::vector<int>& column_start() const { return column_start_; }  ///< size + 1
    const std::vector<int>& rows() const { return rows_; }                  ///< entry_count

  private:
    std::vector<int> column_start_;
    std::vector<int> rows_;
    std::vector<std::size_t> slot_start_;
    std::vector<int> slots_;
};

/// The product A x, where `values` is the lower triangle of the symmetric matrix A.
Eigen::VectorXd product(const SparsePattern& pattern, const Eigen::VectorXd& values, const Eigen::VectorXd& x);

}  // namespace ripstop
