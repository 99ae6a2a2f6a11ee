#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

struct Interval {
    double lower = 0, upper = 0;
};

/// An outline as rows of equal height, from `base` upwards. For each row it holds the range of x that the outline
/// covers anywhere in the row, as intervals from left to right. It contains the outline and no x that the outline
/// does not reach within the row. So if two aligned profiles share no x in any row, the outlines do not overlap.
struct RowProfile {
    std::vector<int> first;           ///< index of each row's first interval, and at the end their number
    std::vector<Interval> intervals;  ///< of all rows
    Eigen::ArrayXd lower, upper;      ///< extent of each row; infinity and -infinity if it is empty
    std::vector<int> divided;         ///< rows with several intervals, beside a hollow that opens upwards or downwards

    int rows() const { return static_cast<int>(lower.size()); }
};

/// Requires a closed outline (first point not repeated) without points below `base`. O(#P + rows) intervals, O(#P
/// rows) time.
RowProfile make_row_profile(const Points2& outline, double base, double row_height);

/// The shifts of `b` along x at which it overlaps `a`, if its base is `rows` rows above that of `a`: open
/// intervals from left to right, the Minkowski difference of the rows. O(rows), plus the divided rows of either.
void find_overlapping_shifts(const RowProfile& a, const RowProfile& b, int rows, std::vector<Interval>& shifts);

}  // namespace ripstop
