#include "ripstop/numeric/symmetric_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <thread>

namespace ripstop {
namespace symmetric_solver_test {

/// A chain of springs of stiffness k; every unknown is also tied to the ground with `ground`.
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

/// A square plate of vertices with two unknowns each, coupled along edges and diagonals as elastic triangles are.
/// It is large enough for dense blocks.
struct Plate {
    explicit Plate(int side) : pattern(2 * side * side, couple(side)) {}

    static Couplings couple(int side) {
        Couplings couplings;
        const auto unknowns = [&](int a, int b, int c) {
            return std::array{2 * a, 2 * a + 1, 2 * b, 2 * b + 1, 2 * c, 2 * c + 1};
        };
        for (int j = 0; j + 1 < side; ++j)
            for (int i = 0; i + 1 < side; ++i) {
                const int a = j * side + i, b = a + 1, c = b + side, d = a + side;
                couplings.add_element(unknowns(a, b, c));
                couplings.add_element(unknowns(a, c, d));
            }
        return couplings;
    }

    /// A weighted Laplacian with varying weights; each unknown is tied to the ground.
    Eigen::VectorXd values(double ground) const {
        Eigen::VectorXd result = Eigen::VectorXd::Zero(pattern.entry_count());
        for (int c = 0; c < pattern.size(); ++c) {
            result[pattern.diagonal_slot(c)] += ground;
            for (int s = pattern.diagonal_slot(c) + 1; s < pattern.column_start()[static_cast<std::size_t>(c) + 1];
                 ++s) {
                const int r = pattern.rows()[static_cast<std::size_t>(s)];
                const double weight = 1.5 + std::sin(0.7 * r + 1.3 * c);
                result[s] = -weight;
                result[pattern.diagonal_slot(c)] += weight;
                result[pattern.diagonal_slot(r)] += weight;
            }
        }
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
    EXPECT_LT(((x - right).head(size).array() - shift).abs().maxCoeff(), 1e-9);  // of the order of δ times the sums
    EXPECT_NEAR(x.head(size).sum(), 2, 1e-10);
}

/// Large systems, which CHOLMOD factorises if the build has it.
class LargeSymmetricSolver : public ::testing::Test {
  protected:
    Plate plate{75};
    Eigen::VectorXd values = plate.values(0.1);
    Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(plate.pattern.size(), -1, 2).array().sin();
};

TEST_F(LargeSymmetricSolver, IsChosenAboveTheCrossOver) {
    const bool built = numeric_libraries().find("CHOLMOD") != std::string::npos;
    EXPECT_EQ(SymmetricSolver(plate.pattern).kind(), built ? SolverKind::supernodal : SolverKind::simplicial);
    EXPECT_EQ(SymmetricSolver(Plate(20).pattern).kind(), SolverKind::simplicial);
}

TEST_F(LargeSymmetricSolver, AgreesWithTheSmallOne) {
    SymmetricSolver large(plate.pattern, SolverKind::supernodal), small(plate.pattern, SolverKind::simplicial);
    ASSERT_TRUE(large.factorize(values));
    ASSERT_TRUE(small.factorize(values));
    const Eigen::VectorXd expected = small.solve(right);
    EXPECT_LT((large.solve(right) - expected).norm(), 1e-10 * expected.norm());
    EXPECT_EQ(large.inertia(), small.inertia());
    EXPECT_EQ(large.inertia().positive, plate.pattern.size());
    EXPECT_LT((product(plate.pattern, values, large.solve(right)) - right).norm(), 1e-10 * right.norm());
}

TEST_F(LargeSymmetricSolver, SolvesSeveralRightHandSidesAtOnce) {
    SymmetricSolver solver(plate.pattern);
    ASSERT_TRUE(solver.factorize(values));
    Eigen::MatrixXd columns(right.size(), 3);
    columns << right, right.cwiseAbs(), right.array().square().matrix();
    const Eigen::MatrixXd x = solver.solve_columns(columns);
    for (int c = 0; c < 3; ++c) {
        const Eigen::VectorXd alone = solver.solve(columns.col(c));
        EXPECT_LT((x.col(c) - alone).norm(), 1e-12 * alone.norm()) << c;
    }
}

TEST_F(LargeSymmetricSolver, ReportsAnIndefiniteMatrixAndGoesOnAfterwards) {
    SymmetricSolver solver(plate.pattern);
    Eigen::VectorXd indefinite = values;
    indefinite[plate.pattern.diagonal_slot(plate.pattern.size() / 2)] -= 100;
    const bool done = solver.factorize(indefinite);
    EXPECT_TRUE(!done || solver.kind() == SolverKind::simplicial);
    EXPECT_GE(solver.inertia().negative, 1);
    ASSERT_TRUE(solver.factorize(values));
    EXPECT_EQ(solver.inertia().negative, 0);
    SymmetricSolver fresh(plate.pattern);
    ASSERT_TRUE(fresh.factorize(values));
    EXPECT_EQ(solver.solve(right), fresh.solve(right));
}

TEST_F(LargeSymmetricSolver, RefusesANotANumber) {
    SymmetricSolver solver(plate.pattern);
    EXPECT_FALSE(solver.factorize(Eigen::VectorXd::Constant(plate.pattern.entry_count(), std::nan(""))));
    EXPECT_EQ(solver.inertia(), Inertia{});
    EXPECT_TRUE(solver.factorize(values));
}

TEST_F(LargeSymmetricSolver, SaysThatAFreeBodyHasAZeroPivot) {
    // x and y are coupled in this plate, so it floats in one direction only
    SymmetricSolver solver(plate.pattern);
    const bool done = solver.factorize(plate.values(0));
    EXPECT_TRUE(!done || solver.inertia().zero == 1);
}

TEST_F(LargeSymmetricSolver, GivesTheSameBytesOnAnyThread) {
    SymmetricSolver solver(plate.pattern);
    ASSERT_TRUE(solver.factorize(values));
    const Eigen::VectorXd expected = solver.solve(right);
    std::array<Eigen::VectorXd, 2> found;
    std::array<std::thread, 2> threads;
    for (std::size_t k = 0; k < threads.size(); ++k)
        threads[k] = std::thread([&, k] {
            SymmetricSolver own(plate.pattern);
            if (own.factorize(values)) found[k] = own.solve(right);
        });
    for (std::thread& thread : threads) thread.join();
    for (const Eigen::VectorXd& x : found) EXPECT_EQ(x, expected);
}

}  // namespace symmetric_solver_test
}  // namespace ripstop
