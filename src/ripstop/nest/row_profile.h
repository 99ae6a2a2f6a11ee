#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

struct Interval {
    double lower = 0, upper = 0;
};

/// An outline as rows of equal height from `base` upwards: for each the x that it covers anywhere in the row, as
/// intervals from left to right. It covers the outline and is no wider than what the outline covers within a row, so
/// two profiles whose rows are aligned and share no x belong to outlines that do not overlap.
struct RowProfile {
    std::vector<int> first;           ///< of each row's intervals, and one more: their number
    std::vector<Interval> intervals;  ///< all rows'
    Eigen::ArrayXd lower, upper;      ///< of each row as a whole; infinite and minus infinite where it is empty
    std::vector<int> divided;         ///< the rows of several intervals: beside a hollow that opens up or down

    int rows() const { return static_cast<int>(lower.size()); }
};

/// Requires an outline (closed, first point not repeated) with no point below `base`. O(#P + rows) intervals, O(#P
/// rows) time.
RowProfile make_row_profile(const Points2& outline, double base, double row_height);

/// The shifts along x by which `b`, its base `rows` rows above that of `a`, overlaps it: open intervals from left to
/// right [Minkowski difference of the rows]. O(rows), and the divided ones of either.
void find_overlapping_shifts(const RowProfile& a, const RowProfile& b, int rows, std::vector<Interval>& shifts);

}  // namespace ripstop
