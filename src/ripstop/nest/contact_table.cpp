#include "ripstop/nest/contact_table.h"

#include "ripstop/base/parallel.h"

namespace ripstop {

namespace {

constexpr double rounding = 2e-6;  // more than the rounding error of single precision within 16 m

}  // namespace

ContactTable::ContactTable(const std::vector<LaidShape>& shapes, int profile_rows, int threads)
    : count_(shapes.size()), pairs_(count_ * count_) {
    const auto item_rows = [profile_rows](const RowProfile& profile) {
        return (profile.rows() + profile_rows - 1) / profile_rows;
    };
    parallel_for(static_cast<int>(count_), threads, [&](int task) {
        const auto a = static_cast<std::size_t>(task);
        std::vector<Interval> shifts;
        for (std::size_t b = a; b < count_; ++b) {
            const RowProfile &one = shapes[a].profile, &other = shapes[b].profile;
            const bool may_divide = !one.divided.empty() || !other.divided.empty();
            Pair& pair = pairs_[a * count_ + b];
            pair.below = item_rows(other) - 1;
            pair.intervals.reserve(static_cast<std::size_t>(item_rows(one) + item_rows(other) - 1));
            for (int rows = -pair.below; rows < item_rows(one); ++rows) {
                find_overlapping_shifts(one, other, rows * profile_rows, shifts);
                if (may_divide) pair.first.push_back(static_cast<int>(pair.intervals.size()));
                if (!may_divide && shifts.empty()) shifts.push_back({0, 0});
                for (const auto& [lower, upper] : shifts)
                    pair.intervals.push_back(
                        {static_cast<float>(lower - rounding), static_cast<float>(upper + rounding)});
            }
            if (may_divide) pair.first.push_back(static_cast<int>(pair.intervals.size()));
        }
    });
}

}  // namespace ripstop
