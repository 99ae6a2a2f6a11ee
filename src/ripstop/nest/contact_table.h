#pragma once

#include <cstddef>
#include <vector>

#include "ripstop/nest/laid_shape.h"

namespace ripstop {

/// For every two shapes and every integer number of rows between their bases: the shifts along the roll at which
/// they overlap. This is the no-fit polygon of each pair, cut into rows. It is in single precision, so it serves
/// the search and not the final placement.
class ContactTable {
  public:
    /// The shapes' profiles have `profile_rows` rows for each row that items lie on. O(shapes² rows² profile_rows)
    /// time on up to `threads` threads, O(shapes² rows) memory: about 100 MB for 400 shapes that are a third of
    /// 200 rows high.
    ContactTable(const std::vector<LaidShape>& shapes, int profile_rows, int threads);

    /// Calls `taken(lower, upper)` for each interval of places x of `other` at which it overlaps `placed`, which
    /// lies at 0; `other` lies `rows` rows higher.
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
        int below = 0;                         ///< rows that the second shape may lie below the first
        std::vector<int> first;                ///< of each row's intervals, plus the end; empty if each row has one
        std::vector<ShortInterval> intervals;  ///< of all rows
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
    std::vector<Pair> pairs_;  ///< for a <= b; the other half stays empty
};

}  // namespace ripstop
