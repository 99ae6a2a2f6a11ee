#include "ripstop/numeric/sparse_pattern.h"

#include <algorithm>
#include <cassert>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

/// Calls visit(row, column) of the lower triangle for every entry of every group, in slot order.
template <class Visit>
void visit_couplings(const Couplings& couplings, Visit&& visit) {
    for (int g = 0; g < couplings.count(); ++g) {
        const int* const first = couplings.unknowns.data() + couplings.start[at(g)];
        const int* const last = couplings.unknowns.data() + couplings.start[static_cast<std::size_t>(g) + 1];
        if (couplings.is_row[at(g)]) {
            for (const int* a = first; a != last; ++a) visit(std::max(*first, *a), std::min(*first, *a));
        } else {
            for (const int* a = first; a != last; ++a)
                for (const int* b = first; b <= a; ++b) visit(std::max(*a, *b), std::min(*a, *b));
        }
    }
}

}  // namespace

int Couplings::add_element(std::span<const int> members) {
    unknowns.insert(unknowns.end(), members.begin(), members.end());
    start.push_back(static_cast<int>(unknowns.size()));
    is_row.push_back(0);
    return count() - 1;
}

int Couplings::add_row(int row, std::span<const int> columns) {
    unknowns.push_back(row);
    unknowns.insert(unknowns.end(), columns.begin(), columns.end());
    start.push_back(static_cast<int>(unknowns.size()));
    is_row.push_back(1);
    return count() - 1;
}

SparsePattern::SparsePattern(int size, const Couplings& couplings) {
    const auto columns = static_cast<std::size_t>(size);
    slot_start_ = {0};
    slot_start_.reserve(static_cast<std::size_t>(couplings.count()) + 1);
    for (std::size_t g = 0; g < couplings.is_row.size(); ++g) {
        const auto members = static_cast<std::size_t>(couplings.start[g + 1] - couplings.start[g]);
        slot_start_.push_back(slot_start_.back() + (couplings.is_row[g] ? members : members * (members + 1) / 2));
    }

    // Sorts the entries by column; slots_ holds their rows until the column is processed.
    slots_.resize(slot_start_.back());
    std::vector<std::size_t> bucket_start(columns + 1, 0);
    visit_couplings(couplings, [&]([[maybe_unused]] int row, int column) {
        assert(column >= 0 && row < size);
        ++bucket_start[static_cast<std::size_t>(column) + 1];
    });
    for (std::size_t c = 0; c < columns; ++c) bucket_start[c + 1] += bucket_start[c];
    std::vector<std::size_t> entries(slots_.size());
    std::size_t entry = 0;
    std::vector<std::size_t> fill(bucket_start.begin(), bucket_start.end() - 1);
    visit_couplings(couplings, [&](int row, int column) {
        slots_[entry] = row;
        entries[fill[at(column)]++] = entry++;
    });

    std::vector<int> slot_of_row(columns, -1);  // slots of the current column; smaller values are stale, from earlier
                                                // columns
    column_start_.assign(columns + 1, 0);
    for (std::size_t c = 0; c < columns; ++c) {
        const int first = static_cast<int>(rows_.size());
        const auto add = [&](int row) {
            int& slot = slot_of_row[at(row)];
            if (slot >= first) return;
            slot = first;
            rows_.push_back(row);
        };
        add(static_cast<int>(c));
        for (std::size_t k = bucket_start[c]; k < bucket_start[c + 1]; ++k) add(slots_[entries[k]]);
        std::sort(rows_.begin() + first, rows_.end());
        for (int s = first; s < static_cast<int>(rows_.size()); ++s) slot_of_row[at(rows_[at(s)])] = s;
        for (std::size_t k = bucket_start[c]; k < bucket_start[c + 1]; ++k)
            slots_[entries[k]] = slot_of_row[at(slots_[entries[k]])];
        column_start_[c + 1] = static_cast<int>(rows_.size());
    }
}

Eigen::VectorXd product(const SparsePattern& pattern, const Eigen::VectorXd& values, const Eigen::VectorXd& x) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(pattern.size());
    for (int c = 0; c < pattern.size(); ++c) {
        int s = pattern.diagonal_slot(c);
        const int end = pattern.column_start()[static_cast<std::size_t>(c) + 1];
        double sum = values[s] * x[c];
        for (++s; s < end; ++s) {
            const int r = pattern.rows()[at(s)];
            sum += values[s] * x[r];
            result[r] += values[s] * x[c];
        }
        result[c] += sum;
    }
    return result;
}

}  // namespace ripstop
