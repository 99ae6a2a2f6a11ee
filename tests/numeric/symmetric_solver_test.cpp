#include "ripstop/numeric/symmetric_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

/// A chain of springs of stiffness k, every unknown also tied to the ground with `ground`.
struct Chain {
    explicit Chain(int size) : pattern(size, couple(size)) {}

    static Couplings couple(int size) {
        Couplings couplings;
        for (int i = 0; i + 1 < size; ++i) couplings.add_element(std::array{i, i + 1});
        return couplings;
    }

    Eigen::VectorXd values(double k, double ground) const {
        Eigen::VectorXd result = Eigen::VectorXd::Zero(pattern.entry_count());
        for (int g = 0; g + 1 < pattern.size(); ++g) {
            const auto slots = pattern.slots(g);
            result[slots[0]] += k;
            result[slots[1]] -= k;
            result[slots[2]] += k;
        }
        for (int i = 0; i < pattern.size(); ++i) result[pattern.diagonal_slot(i)] += ground;
        return result;
    }

    SparsePattern pattern;
};

TEST(SymmetricSolver, FindsTheSolutionThatWasPutIn) {
    const Chain chain(50);
    SymmetricSolver solver(chain.pattern);
    const Eigen::VectorXd values = chain.values(3, 0.5);
    ASSERT_TRUE(solver.factorize(values));
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(50, -1, 2).array().sin();
    EXPECT_LT((solver.solve(product(chain.pattern, values, x)) - x).norm(), 1e-13 * x.norm());
}

TEST(SymmetricSolver, SolvesSeveralRightHandSidesAsIfEachWereAlone) {
    const Chain chain(20);
    SymmetricSolver solver(chain.pattern);
    ASSERT_TRUE(solver.factorize(chain.values(1, 1)));
    Eigen::MatrixXd right(20, 3);
    right << Eigen::VectorXd::LinSpaced(20, 0, 1), Eigen::VectorXd::Ones(20), Eigen::VectorXd::Unit(20, 7);
    const Eigen::MatrixXd x = solver.solve_columns(right);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(x.col(c), solver.solve(right.col(c)));
}

TEST(SymmetricSolver, RefactorisesOtherValuesAndCounts) {
    const Chain chain(30);
    SymmetricSolver solver(chain.pattern);
    EXPECT_EQ(solver.factorizations(), 0);
    ASSERT_TRUE(solver.factorize(chain.values(1, 1)));
    ASSERT_TRUE(solver.factorize(chain.values(2, 0.1)));
    EXPECT_EQ(solver.factorizations(), 2);
    SymmetricSolver fresh(chain.pattern);
    ASSERT_TRUE(fresh.factorize(chain.values(2, 0.1)));
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(30);
    EXPECT_EQ(solver.solve(right), fresh.solve(right));
}

TEST(SymmetricSolver, CountsTheSignsOfTheEigenvalues) {
    // The free chain has the eigenvalues 2 - 2 cos(pi j / n), j = 0 … n - 1.
    constexpr int size = 25;
    const Chain chain(size);
    SymmetricSolver solver(chain.pattern);
    for (const double shift : {0.3, 1.1, 3.0}) {
        int below = 0;
        for (int j = 0; j < size; ++j) below += 2 - 2 * std::cos(std::numbers::pi * j / size) < shift;
        ASSERT_TRUE(solver.factorize(chain.values(1, -shift)));
        EXPECT_EQ(solver.inertia(), (Inertia{size - below, below, 0})) << shift;
    }
}

TEST(SymmetricSolver, SaysThatAFreeBodyHasAZeroPivot) {
    const Chain chain(25);
    SymmetricSolver solver(chain.pattern);
    const bool done = solver.factorize(chain.values(0.1, 0));
    EXPECT_TRUE(!done || solver.inertia().zero == 1);
}

TEST(SymmetricSolver, RefusesAZeroAndANotANumber) {
    const Chain chain(5);
    SymmetricSolver solver(chain.pattern);
    EXPECT_FALSE(solver.factorize(Eigen::VectorXd::Zero(chain.pattern.entry_count())));
    EXPECT_EQ(solver.inertia(), Inertia{});
    EXPECT_FALSE(solver.factorize(Eigen::VectorXd::Constant(chain.pattern.entry_count(), std::nan(""))));
    EXPECT_TRUE(solver.factorize(chain.values(1, 1)));
}

TEST(SymmetricSolver, SolvesAConstrainedSystem) {
    // min ½ |x|² - x · f with sum x = 2, regularised by δ: x = f + λ, λ = (2 - sum f) / n.
    constexpr int size = 12;
    constexpr double delta = 1e-12;
    Couplings couplings;
    std::vector<int> all;
    for (int i = 0; i < size; ++i) all.push_back(i);
    const int row = couplings.add_row(size, all);
    const SparsePattern pattern(size + 1, couplings);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern.entry_count());
    for (int i = 0; i < size; ++i) values[pattern.diagonal_slot(i)] = 1;
    for (std::size_t k = 1; k <= size; ++k) values[pattern.slots(row)[k]] = 1;
    values[pattern.slots(row)[0]] = -delta;
    SymmetricSolver solver(pattern);
    ASSERT_TRUE(solver.factorize(values));
    EXPECT_EQ(solver.inertia(), (Inertia{size, 1, 0}));
    Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(size + 1, 0, size);
    right[size] = 2;
    const Eigen::VectorXd x = solver.solve(right);
    const double shift = (2 - right.head(size).sum()) / size;
    EXPECT_LT(((x - right).head(size).array() - shift).abs().maxCoeff(), 1e-9);  // of the order δ times the sums
    EXPECT_NEAR(x.head(size).sum(), 2, 1e-10);
}

}  // namespace
}  // namespace ripstop
