#pragma once

#include <cstddef>
#include <vector>

#include "ripstop/nest/laid_shape.h"

namespace ripstop {

/// For every two shapes and every whole number of rows between their bases, the shifts along the roll by which they
/// overlap: the no-fit polygons of all pairs, cut into rows. Single precision: for searching, not for the last word.
class ContactTable {
  public:
    /// The shapes' profiles have `profile_rows` rows to a row that items lie on. O(shapes2 rows2 profile_rows) time on
    /// up to `threads` threads, O(shapes2 rows) memory: some 100 MB for 400 shapes a third of 200 rows high.
    ContactTable(const std::vector<LaidShape>& shapes, int profile_rows, int threads);

    /// Calls `taken(lower, upper)` for the places x of `other`, `rows` rows above `placed` that lies at 0, at which
    /// they overlap.
    template <class Taken>
    void each(int placed, int other, int rows, Taken&& taken) const {
        if (placed <= other) {
            for (const auto& [lower, upper] : at(placed, other, rows)) taken(double(lower), double(upper));
        } else {
            for (const auto& [lower, upper] : at(other, placed, -rows)) taken(-double(upper), -double(lower));
        }
    }

  private:
    struct ShortInterval {
        float lower, upper;
    };
    struct Range {
        const ShortInterval *first, *last;
        const ShortInterval* begin() const { return first; }
        const ShortInterval* end() const { return last; }
    };
    struct Pair {
        int below = 0;                         ///< rows that the second may lie below the first
        std::vector<int> first;                ///< of each row's intervals, and one more; none where each has one
        std::vector<ShortInterval> intervals;  ///< all rows'
    };

    Range at(int a, int b, int rows) const {
        const Pair& pair = pairs_[static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b)];
        const int row = rows + pair.below;
        if (row < 0) return {nullptr, nullptr};
        const auto r = static_cast<std::size_t>(row);
        const ShortInterval* data = pair.intervals.data();
        if (pair.first.empty())
            return r < pair.intervals.size() ? Range{data + r, data + r + 1} : Range{nullptr, nullptr};
        return r + 1 < pair.first.size() ? Range{data + pair.first[r], data + pair.first[r + 1]}
                                         : Range{nullptr, nullptr};
    }

    std::size_t count_;
    std::vector<Pair> pairs_;  ///< of a <= b; the others stay empty
};

}  // namespace ripstop
