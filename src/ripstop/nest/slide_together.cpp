#include "ripstop/nest/slide_together.h"

#include <algorithm>
#include <cmath>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

/// The item lies at least `distance` beyond another.
struct Limit {
    std::size_t other;
    double distance;
};

/// Adds the distance that the item must keep beyond the other; no limit if it may lie before it.
void add_limit(std::vector<Limit>& limits, std::size_t other, double apart, const std::vector<Interval>& overlapping) {
    for (auto shift = overlapping.rbegin(); shift != overlapping.rend(); ++shift) {
        if (apart < (shift->lower + shift->upper) / 2)
            continue;  // outside of the interval, on one of its sides, up to rounding
        limits.push_back({other, shift->upper});
        return;
    }
}

}  // namespace

void slide_together(const Strip& strip, const FineRows& rows, std::vector<PlacedItem>& items) {
    std::stable_sort(items.begin(), items.end(), [](const PlacedItem& a, const PlacedItem& b) { return a.x < b.x; });
    double longest = 0;
    std::vector<RowProfile> profiles(strip.shapes.size());
    for (const PlacedItem& item : items) {
        RowProfile& profile = profiles[at(item.shape)];
        const LaidShape& shape = strip.shape(item);
        longest = std::max(longest, shape.size.x());
        if (profile.rows() == 0) profile = make_row_profile(shape.grown, rows.base, rows.height);
    }
    const double seen = longest + 2 * strip.gap + 0.01;  // farther apart, only the ends matter
    std::vector<std::vector<Limit>> limits(items.size());
    std::vector<double> first(items.size());
    std::vector<std::size_t> before(items.size());  // for each item, the first one close enough to limit it
    std::vector<Interval> overlapping;
    for (std::size_t i = 0; i < items.size(); ++i) {
        first[i] = std::max(strip.start, strip.joins.before(items[i].x));
        for (before[i] = i > 0 ? before[i - 1] : 0; items[before[i]].x + seen <= items[i].x;) ++before[i];
        for (std::size_t k = before[i]; k < i; ++k) {
            find_overlapping_shifts(profiles[at(items[k].shape)], profiles[at(items[i].shape)],
                                    rows.times * (items[i].row - items[k].row), overlapping);
            add_limit(limits[i], k, items[i].x - items[k].x, overlapping);
            for (Interval& shift : overlapping) shift = {-shift.upper, -shift.lower};
            std::reverse(overlapping.begin(), overlapping.end());
            add_limit(limits[k], i, items[k].x - items[i].x, overlapping);
        }
    }
    std::vector<double> ends(items.size());  // for each item, the largest end of it and those before it
    for (bool has_moved = true; has_moved;) {
        has_moved = false;
        for (std::size_t i = 0; i < items.size(); ++i) {
            double x = first[i];
            if (before[i] > 0) x = std::max(x, ends[before[i] - 1] + strip.gap);
            for (const Limit& limit : limits[i]) x = std::max(x, items[limit.other].x + limit.distance);
            if (x < items[i].x) {
                has_moved = has_moved || x < items[i].x - 1e-9;
                items[i].x = x;
            }
            ends[i] = std::max(strip.end(items[i]), i > 0 ? ends[i - 1] : 0);
        }
    }
}

}  // namespace ripstop
