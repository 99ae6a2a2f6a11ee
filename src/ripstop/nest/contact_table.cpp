#include "ripstop/nest/contact_table.h"

#include "ripstop/base/parallel.h"

namespace ripstop {

namespace {

constexpr double rounding = 2e-6;  // more than single precision takes away within 16 m

}  // namespace

ContactTable::ContactTable(const std::vector<LaidShape>& shapes, int threads)
    : count_(shapes.size()), pairs_(count_ * count_) {
    parallel_for(static_cast<int>(count_), threads, [&](int task) {
        const auto a = static_cast<std::size_t>(task);
        std::vector<Interval> shifts;
        for (std::size_t b = a; b < count_; ++b) {
            const RowProfile &one = shapes[a].profile, &other = shapes[b].profile;
            const bool is_simple = one.is_simple && other.is_simple;
            Pair& pair = pairs_[a * count_ + b];
            pair.below = other.rows() - 1;
            pair.intervals.reserve(static_cast<std::size_t>(one.rows() + other.rows() - 1));
            for (int rows = -pair.below; rows < one.rows(); ++rows) {
                if (!is_simple) pair.first.push_back(static_cast<int>(pair.intervals.size()));
                find_overlapping_shifts(one, other, rows, shifts);
                if (is_simple && shifts.empty()) shifts.push_back({0, 0});
                for (const auto& [lower, upper] : shifts)
                    pair.intervals.push_back(
                        {static_cast<float>(lower - rounding), static_cast<float>(upper + rounding)});
            }
            if (!is_simple) pair.first.push_back(static_cast<int>(pair.intervals.size()));
        }
    });
}

}  // namespace ripstop
