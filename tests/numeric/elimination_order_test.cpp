#include "ripstop/numeric/elimination_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace elimination_order_test {

/// A grid of vertices with `each` unknowns per vertex; the vertices of a cell are coupled.
SparsePattern grid_pattern(int side, int each) {
    Couplings couplings;
    for (int j = 0; j + 1 < side; ++j)
        for (int i = 0; i + 1 < side; ++i) {
            std::vector<int> unknowns;
            for (const int v : {j * side + i, j * side + i + 1, (j + 1) * side + i, (j + 1) * side + i + 1})
                for (int a = 0; a < each; ++a) unknowns.push_back(each * v + a);
            couplings.add_element(unknowns);
        }
    return SparsePattern(each * side * side, couplings);
}

long fill(const SparsePattern& pattern) {
    Eigen::VectorXd identity = Eigen::VectorXd::Zero(pattern.entry_count());
    for (int i = 0; i < pattern.size(); ++i) identity[pattern.diagonal_slot(i)] = 1;
    SymmetricSolver solver(pattern, SolverKind::simplicial);
    return solver.factorize(identity) ? solver.factor_entries() : 0;
}

TEST(EliminationOrder, NamesEveryUnknownOnce) {
    for (const int each : {1, 2, 3}) {
        std::vector<int> order = elimination_order(grid_pattern(9, each));
        std::sort(order.begin(), order.end());
        std::vector<int> all(order.size());
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(order, all);
    }
    EXPECT_TRUE(elimination_order(SparsePattern(0, {})).empty());
}

TEST(EliminationOrder, TakesTheUnknownsOfAVertexTogether) {
    const std::vector<int> order = elimination_order(grid_pattern(9, 2));
    for (std::size_t k = 0; k < order.size(); k += 2) EXPECT_EQ(order[k] / 2, order[k + 1] / 2) << k;
}

TEST(EliminationOrder, LeavesAStarWithoutFill) {
    // eliminating the hub first would couple all of its neighbours
    constexpr int arms = 40;
    Couplings couplings;
    std::array<int, arms> others{};
    std::iota(others.begin(), others.end(), 1);
    couplings.add_row(0, others);
    EXPECT_EQ(fill(SparsePattern(arms + 1, couplings)), arms);
}

TEST(EliminationOrder, FillsFourTimesAsMuchForTwoUnknownsAVertex) {
    // each entry of the vertices' factor becomes a 2 x 2 block; each diagonal one gets an entry below it
    constexpr int side = 30;
    EXPECT_EQ(fill(grid_pattern(side, 2)), 4 * fill(grid_pattern(side, 1)) + side * side);
}

TEST(Renumbered, PutsEveryValueWhereItsUnknownsWent) {
    Couplings couplings;
    couplings.add_element(std::array{0, 1});
    couplings.add_element(std::array{1, 2});
    const SparsePattern pattern(3, couplings);  // columns {0, 1}, {1, 2}, {2}: slots 0 1 | 2 3 | 4
    const std::vector<int> order = {2, 0, 1};
    const OrderedTriangle upper = renumbered(pattern, order, Triangle::upper);
    EXPECT_EQ(upper.column_start, (std::vector{0, 1, 2, 5}));
    EXPECT_EQ(upper.rows, (std::vector{0, 1, 0, 1, 2}));
    EXPECT_EQ(upper.slots, (std::vector{4, 0, 3, 1, 2}));
    const OrderedTriangle lower = renumbered(pattern, order, Triangle::lower);
    EXPECT_EQ(lower.column_start, (std::vector{0, 2, 4, 5}));
    EXPECT_EQ(lower.rows, (std::vector{0, 2, 1, 2, 2}));
    EXPECT_EQ(lower.slots, (std::vector{4, 3, 0, 1, 2}));
}

}  // namespace elimination_order_test
}  // namespace ripstop
