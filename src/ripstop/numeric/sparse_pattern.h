#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace ripstop {

/// Which unknowns of a symmetric system meet, listed group by group. A group is numbered by its place in the list.
struct Couplings {
    /// An element: all of its unknowns meet each other. Its entries are those of the element's own lower triangle row
    /// by row, so entry (a, b), a >= b, is number a (a + 1) / 2 + b. Unknowns are distinct.
    int add_element(std::span<const int> unknowns);

    /// A row, such as a constraint's: `row` meets itself (entry 0) and each of `columns` (entry 1 + j), but these do
    /// not meet each other. Unknowns are distinct.
    int add_row(int row, std::span<const int> columns);

    int count() const { return static_cast<int>(is_row.size()); }

    std::vector<int> start = {
        0};  ///< group g is unknowns[start[g]] … unknowns[start[g + 1] - 1]; of a row, `row` first
    std::vector<int> unknowns;
    std::vector<char> is_row;
};

/// The places of a sparse symmetric matrix that can be other than zero: its lower triangle, column by column, rows
/// increasing, the whole diagonal always among them. Built once; afterwards an assembly is
///
///     values.setZero();
///     for each group g:  for each entry k:  values[pattern.slots(g)[k]] += ...
///
/// with no search, no sort and one order of the sums. Building takes O(entries of all groups).
class SparsePattern {
  public:
    SparsePattern(int size, const Couplings& couplings);

    int size() const { return static_cast<int>(column_start_.size()) - 1; }
    int entry_count() const { return static_cast<int>(rows_.size()); }

    /// Where each entry of a group lies in the values, in the group's own order.
    std::span<const int> slots(int group) const {
        const auto g = static_cast<std::size_t>(group);
        return {slots_.data() + slot_start_[g], slots_.data() + slot_start_[g + 1]};
    }
    int diagonal_slot(int unknown) const { return column_start_[static_cast<std::size_t>(unknown)]; }

    const std::vector<int>& column_start() const { return column_start_; }  ///< size + 1
    const std::vector<int>& rows() const { return rows_; }                  ///< entry_count

  private:
    std::vector<int> column_start_;
    std::vector<int> rows_;
    std::vector<std::size_t> slot_start_;
    std::vector<int> slots_;
};

/// A x for the symmetric matrix whose lower triangle `values` holds.
Eigen::VectorXd product(const SparsePattern& pattern, const Eigen::VectorXd& values, const Eigen::VectorXd& x);

}  // namespace ripstop
