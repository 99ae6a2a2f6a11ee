#include "ripstop/numeric/elimination_order.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include "ripstop/base/index.h"

namespace ripstop {
namespace {

/// Calls visit(row, column, slot) for every entry of the lower triangle.
template <class Visit>
void visit_pattern(const SparsePattern& pattern, Visit&& visit) {
    for (int c = 0; c < pattern.size(); ++c)
        for (int s = pattern.column_start()[at(c)]; s < pattern.column_start()[at(c + 1)]; ++s)
            visit(pattern.rows()[at(s)], c, s);
}

std::uint64_t scrambled(int i) {
    std::uint64_t x = static_cast<std::uint64_t>(i) + 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The group of each unknown, numbered without gaps. Consecutive unknowns with the same neighbours form a group,
/// detected by equal sums of hashes over the neighbours. A collision is very unlikely and would only cost fill.
std::vector<int> groups_of_twins(const SparsePattern& pattern) {
    std::vector<std::uint64_t> met(at(pattern.size()), 0);
    visit_pattern(pattern, [&](int row, int column, int) {
        met[at(row)] += scrambled(column);
        if (row != column) met[at(column)] += scrambled(row);
    });
    std::vector<int> group(met.size(), 0);
    for (std::size_t i = 1; i < met.size(); ++i) group[i] = group[i - 1] + (met[i] == met[i - 1] ? 0 : 1);
    return group;
}

/// Minimum degree ordering of the graph of groups.
std::vector<int> minimum_degree(const SparsePattern& pattern) {
    if (pattern.size() == 0) return {};
    using Matrix = Eigen::SparseMatrix<signed char>;
    const std::vector<int> group = groups_of_twins(pattern);
    const int count = group.back() + 1;
    const auto leads = [&](int i) { return i == 0 || group[at(i)] != group[at(i - 1)]; };
    std::vector<int> column_start = {0}, rows;
    for (int c = 0; c < pattern.size(); ++c) {
        if (!leads(c)) continue;
        for (int s = pattern.column_start()[at(c)]; s < pattern.column_start()[at(c + 1)]; ++s)
            if (const int r = pattern.rows()[at(s)]; leads(r)) rows.push_back(group[at(r)]);
        column_start.push_back(static_cast<int>(rows.size()));
    }
    const std::vector<signed char> ones(rows.size(), 1);
    const Eigen::Map<const Matrix> lower(count, count, static_cast<int>(rows.size()), column_start.data(), rows.data(),
                                         ones.data());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
    Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), permutation);

    std::vector<int> first(at(count) + 1, pattern.size());
    for (int i = pattern.size() - 1; i >= 0; --i) first[at(group[at(i)])] = i;
    std::vector<int> order;
    order.reserve(group.size());
    for (int k = 0; k < count; ++k) {
        const int g = permutation.indices()[k];
        for (int i = first[at(g)]; i < first[at(g + 1)]; ++i) order.push_back(i);
    }
    return order;
}

/// The parent of each unknown in the elimination tree, -1 for a root [Liu 1986], from the upper triangle.
std::vector<int> elimination_tree(const OrderedTriangle& upper) {
    const std::size_t size = upper.column_start.size() - 1;
    std::vector<int> parent(size, -1), ancestor(size, -1);
    for (std::size_t c = 0; c < size; ++c)
        for (int s = upper.column_start[c]; s < upper.column_start[c + 1]; ++s)
            for (int i = upper.rows[at(s)]; i >= 0 && i < static_cast<int>(c);) {
                const int next = ancestor[at(i)];
                ancestor[at(i)] = static_cast<int>(c);
                if (next < 0) parent[at(i)] = static_cast<int>(c);
                i = next;
            }
    return parent;
}

/// Postorder: subtree by subtree, children in increasing order before their parent.
std::vector<int> postorder(const std::vector<int>& parent) {
    const int size = static_cast<int>(parent.size());
    std::vector<int> child(parent.size(), -1), sibling(parent.size(), -1), stack, order;
    for (int i = size - 1; i >= 0; --i)
        if (const int p = parent[at(i)]; p >= 0) {
            sibling[at(i)] = child[at(p)];
            child[at(p)] = i;
        }
    order.reserve(parent.size());
    for (int root = 0; root < size; ++root) {
        if (parent[at(root)] >= 0) continue;
        stack.push_back(root);
        while (!stack.empty()) {
            const int i = stack.back();
            if (const int c = child[at(i)]; c >= 0) {
                child[at(i)] = sibling[at(c)];
                stack.push_back(c);
            } else {
                order.push_back(i);
                stack.pop_back();
            }
        }
    }
    return order;
}

}  // namespace

std::vector<int> elimination_order(const SparsePattern& pattern) {
    const std::vector<int> degree_order = minimum_degree(pattern);
    std::vector<int> order = postorder(elimination_tree(renumbered(pattern, degree_order, Triangle::upper)));
    for (int& k : order) k = degree_order[at(k)];
    return order;
}

OrderedTriangle renumbered(const SparsePattern& pattern, const std::vector<int>& order, Triangle triangle) {
    std::vector<int> number(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) number[at(order[k])] = static_cast<int>(k);
    const auto count = at(pattern.entry_count());
    const auto place = [&](int row, int column) {
        const auto [low, high] = std::minmax(number[at(row)], number[at(column)]);
        return triangle == Triangle::upper ? std::pair(low, high) : std::pair(high, low);
    };

    // Sorts by row, then stably by column, so that rows increase within a column.
    std::vector<int> row_start(order.size() + 1, 0), column_start(order.size() + 1, 0);
    visit_pattern(pattern, [&](int r, int c, int) {
        const auto [row, column] = place(r, c);
        ++row_start[at(row) + 1];
        ++column_start[at(column) + 1];
    });
    std::partial_sum(row_start.begin(), row_start.end(), row_start.begin());
    std::partial_sum(column_start.begin(), column_start.end(), column_start.begin());
    struct Entry {
        int row, column, slot;
    };
    std::vector<Entry> by_row(count);
    std::vector<int> next = row_start;
    visit_pattern(pattern, [&](int r, int c, int slot) {
        const auto [row, column] = place(r, c);
        by_row[at(next[at(row)]++)] = {row, column, slot};
    });
    OrderedTriangle result{column_start, std::vector<int>(count), std::vector<int>(count)};
    next = std::move(column_start);
    for (const Entry& entry : by_row) {
        const auto k = at(next[at(entry.column)]++);
        result.rows[k] = entry.row;
        result.slots[k] = entry.slot;
    }
    return result;
}

}  // namespace ripstop
