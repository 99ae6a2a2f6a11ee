#include "ripstop/numeric/sparse_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace ripstop {
namespace sparse_pattern_test {

/// The dense symmetric matrix that `values` represents.
Eigen::MatrixXd dense(const SparsePattern& pattern, const Eigen::VectorXd& values) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(pattern.size(), pattern.size());
    for (int c = 0; c < pattern.size(); ++c)
        for (int s = pattern.diagonal_slot(c); s < pattern.column_start()[static_cast<std::size_t>(c) + 1]; ++s) {
            const int r = pattern.rows()[static_cast<std::size_t>(s)];
            matrix(r, c) = matrix(c, r) = values[s];
        }
    return matrix;
}

TEST(SparsePattern, NumbersTheLowerTriangleColumnByColumn) {
    Couplings couplings;
    couplings.add_element(std::array{2, 0});
    couplings.add_element(std::array{3, 2});
    const SparsePattern pattern(4, couplings);
    EXPECT_EQ(pattern.column_start(), (std::vector<int>{0, 2, 3, 5, 6}));
    EXPECT_EQ(pattern.rows(), (std::vector<int>{0, 2, 1, 2, 3, 3}));
    EXPECT_EQ(std::vector<int>(pattern.slots(0).begin(), pattern.slots(0).end()), (std::vector<int>{3, 1, 0}));
    EXPECT_EQ(std::vector<int>(pattern.slots(1).begin(), pattern.slots(1).end()), (std::vector<int>{5, 4, 3}));
}

TEST(SparsePattern, HasEveryDiagonalEvenOfAnUnknownThatNothingTouches) {
    const SparsePattern pattern(3, Couplings{});
    EXPECT_EQ(pattern.entry_count(), 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(pattern.diagonal_slot(i), i);
}

TEST(SparsePattern, KeepsARowsColumnsApart) {
    Couplings couplings;
    couplings.add_row(2, std::array{0, 1, 3});
    const SparsePattern pattern(4, couplings);
    EXPECT_EQ(pattern.entry_count(), 4 + 3);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern.entry_count());
    for (int k = 0; k < 4; ++k) values[pattern.slots(0)[static_cast<std::size_t>(k)]] += k + 1;
    Eigen::Matrix4d expected;
    expected << 0, 0, 2, 0, 0, 0, 3, 0, 2, 3, 1, 4, 0, 0, 4, 0;
    EXPECT_EQ(dense(pattern, values), Eigen::MatrixXd(expected));
}

TEST(SparsePattern, AssemblesWhatADenseMatrixDoes) {
    constexpr int size = 40;
    std::mt19937 random(5);
    std::uniform_int_distribution<int> unknown(0, size - 1);
    std::uniform_int_distribution<int> whole(-9, 9);
    Couplings couplings;
    for (int g = 0; g < 60; ++g) {
        std::vector<int> members;
        while (members.size() < 6) {
            const int candidate = unknown(random);
            if (std::find(members.begin(), members.end(), candidate) == members.end()) members.push_back(candidate);
        }
        couplings.add_element(members);
    }
    const SparsePattern pattern(size, couplings);
    Eigen::VectorXd values = Eigen::VectorXd::Zero(pattern.entry_count());
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(size, size);
    for (int g = 0; g < couplings.count(); ++g) {
        std::size_t k = 0;
        for (int a = 0; a < 6; ++a)
            for (int b = 0; b <= a; ++b) {
                const double value = whole(random);
                values[pattern.slots(g)[k++]] += value;
                const int i = couplings.unknowns[static_cast<std::size_t>(6 * g + a)];
                const int j = couplings.unknowns[static_cast<std::size_t>(6 * g + b)];
                expected(i, j) += value;
                if (i != j) expected(j, i) += value;
            }
    }
    EXPECT_EQ(dense(pattern, values), expected);  // integers, so exact
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, 1, size);
    EXPECT_EQ(product(pattern, values, x), expected * x);
}

}  // namespace sparse_pattern_test
}  // namespace ripstop
