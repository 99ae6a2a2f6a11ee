#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "ripstop/base/index.h"

namespace ripstop {

/// Union-find over the numbers from 0 on. The root of a set is its smallest member, unless `join_into` chooses
/// another. `root` and `join` take amortised O(log n).
class UnionFind {
  public:
    /// Starts with `count` sets of one number each.
    explicit UnionFind(std::size_t count = 0) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    /// Adds a set of one number and returns that number.
    int add() {
        parent_.push_back(static_cast<int>(parent_.size()));
        return parent_.back();
    }

    int root(int i) {
        while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
        return i;
    }
    bool is_root(int i) const { return parent_[at(i)] == i; }

    /// Unites two sets; the smaller root stays. Returns false if they were one set already.
    bool join(int i, int j) {
        const int a = root(i), b = root(j);
        parent_[at(std::max(a, b))] = std::min(a, b);
        return a != b;
    }

    /// Unites two sets; the root of `into` stays.
    void join_into(int i, int into) { parent_[at(root(i))] = root(into); }

    /// The set of each number; sets are numbered from 0 in the order of their first members.
    std::vector<int> numbers() {
        std::vector<int> of_root(parent_.size(), -1), found;
        int count = 0;
        for (int i = 0; i < static_cast<int>(parent_.size()); ++i) {
            int& number = of_root[at(root(i))];
            if (number < 0) number = count++;
            found.push_back(number);
        }
        return found;
    }

  private:
    std::vector<int> parent_;
};

}  // namespace ripstop
