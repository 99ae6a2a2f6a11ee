#include "ripstop/nest/row_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"
#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

constexpr double touching = 1e-9;  // [m] intervals this close touch, because of rounding

/// Adds an interval to sorted disjoint ones and merges those it touches.
void add_interval(std::vector<Interval>& intervals, Interval added) {
    auto at = intervals.begin();
    while (at != intervals.end() && at->upper < added.lower - touching) ++at;
    auto end = at;
    for (; end != intervals.end() && end->lower <= added.upper + touching; ++end) {
        added.lower = std::min(added.lower, end->lower);
        added.upper = std::max(added.upper, end->upper);
    }
    if (at == end) {
        intervals.insert(at, added);
        return;
    }
    *at = added;
    intervals.erase(at + 1, end);
}

/// Adds the part that a segment covers in each row it passes.
void add_segment(std::vector<std::vector<Interval>>& rows, Vec2 from, Vec2 to, double base, double height) {
    if (from.y() > to.y()) std::swap(from, to);
    const auto row_of = [&](double y) {
        return std::clamp(static_cast<int>(std::floor((y - base) / height)), 0, static_cast<int>(rows.size()) - 1);
    };
    const double rise = to.y() - from.y();
    for (int row = row_of(from.y()); row <= row_of(to.y()); ++row) {
        const double start = rise > 0 ? std::clamp((base + row * height - from.y()) / rise, 0.0, 1.0) : 0.0;
        const double end = rise > 0 ? std::clamp((base + (row + 1) * height - from.y()) / rise, 0.0, 1.0) : 1.0;
        const double x = from.x() + start * (to - from).x(), x_end = from.x() + end * (to - from).x();
        add_interval(rows[at(row)], {std::min(x, x_end), std::max(x, x_end)});
    }
}

/// Adds the shifts at which two rows overlap, for each pair of their intervals.
void add_row(const RowProfile& a, int row_a, const RowProfile& b, int row_b, std::vector<Interval>& shifts) {
    const auto r = static_cast<std::size_t>(row_a), s = static_cast<std::size_t>(row_b);
    for (int i = a.first[r]; i < a.first[r + 1]; ++i)
        for (int k = b.first[s]; k < b.first[s + 1]; ++k) {
            const Interval& one = a.intervals[at(i)];
            const Interval& other = b.intervals[at(k)];
            add_interval(shifts, {one.lower - other.upper, one.upper - other.lower});
        }
}

}  // namespace

RowProfile make_row_profile(const Points2& outline, double base, double row_height) {
    const double height = outline.col(1).maxCoeff() - base;
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(height / row_height - 1e-9)));
    std::vector<std::vector<Interval>> rows(count);
    for (Eigen::Index i = 0; i < outline.rows(); ++i)
        add_segment(rows, outline.row(i), outline.row((i + 1) % outline.rows()), base, row_height);
    RowProfile profile;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    profile.lower.setConstant(static_cast<Eigen::Index>(count), infinite);
    profile.upper.setConstant(static_cast<Eigen::Index>(count), -infinite);
    for (std::size_t row = 0; row < count; ++row) {
        // From any inner point, the straight way up or down to the row's middle stays inside or meets a segment.
        for (const auto& [lower, upper] : horizontal_chords(outline, base + (double(row) + 0.5) * row_height))
            add_interval(rows[row], {lower, upper});
        profile.first.push_back(static_cast<int>(profile.intervals.size()));
        profile.intervals.insert(profile.intervals.end(), rows[row].begin(), rows[row].end());
        if (rows[row].size() > 1) profile.divided.push_back(static_cast<int>(row));
        if (rows[row].empty()) continue;
        profile.lower[static_cast<Eigen::Index>(row)] = rows[row].front().lower;
        profile.upper[static_cast<Eigen::Index>(row)] = rows[row].back().upper;
    }
    profile.first.push_back(static_cast<int>(profile.intervals.size()));
    return profile;
}

void find_overlapping_shifts(const RowProfile& a, const RowProfile& b, int rows, std::vector<Interval>& shifts) {
    shifts.clear();
    const int start = std::max(0, rows), end = std::min(a.rows(), b.rows() + rows);
    // Consecutive rows that are single intervals give contiguous shifts, so their extremes suffice.
    const auto add_run = [&](int from, int to) {
        if (from >= to) return;
        const int count = to - from;
        const double lower = (a.lower.segment(from, count) - b.upper.segment(from - rows, count)).minCoeff();
        const double upper = (a.upper.segment(from, count) - b.lower.segment(from - rows, count)).maxCoeff();
        if (lower < upper) add_interval(shifts, {lower, upper});
    };
    auto next_a = std::lower_bound(a.divided.begin(), a.divided.end(), start);
    auto next_b = std::lower_bound(b.divided.begin(), b.divided.end(), start - rows);
    int from = start;
    while (true) {
        int row = end;
        if (next_a != a.divided.end()) row = std::min(row, *next_a);
        if (next_b != b.divided.end()) row = std::min(row, *next_b + rows);
        add_run(from, row);
        if (row >= end) return;
        add_row(a, row, b, row - rows, shifts);
        if (next_a != a.divided.end() && *next_a == row) ++next_a;
        if (next_b != b.divided.end() && *next_b + rows == row) ++next_b;
        from = row + 1;
    }
}

}  // namespace ripstop
