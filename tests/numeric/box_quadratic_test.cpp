#include "ripstop/numeric/box_quadratic.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace ripstop {
namespace box_quadratic_test {

using Vector = Eigen::VectorXd;

constexpr int size = 40;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A chain of springs that push each other, on soft ground.
struct Springs {
    SparsePattern pattern = [] {
        Couplings couplings;
        for (int i = 0; i + 1 < size; ++i) couplings.add_element(std::array{i, i + 1});
        return SparsePattern(size, couplings);
    }();
    SymmetricSolver solver{pattern};
    Vector values = Vector::Zero(pattern.entry_count());
    Vector g;

    explicit Springs(double ground = 0.01) {
        for (int i = 0; i + 1 < size; ++i) {
            const auto slots = pattern.slots(i);
            values[slots[0]] += 1;
            values[slots[1]] -= 1;
            values[slots[2]] += 1;
        }
        for (int i = 0; i < size; ++i) values[pattern.diagonal_slot(i)] += ground;
        std::mt19937 random(4);
        std::normal_distribution<double> push;
        g = Vector::NullaryExpr(size, [&](Eigen::Index) { return push(random); });
    }

    std::optional<Vector> minimize(double below, double above) {
        return minimize_in_box(pattern, solver, values, g, Vector::Constant(size, -below),
                               Vector::Constant(size, above));
    }
};

TEST(BoxQuadratic, WithoutBoundsIsTheSolutionOfTheSystem) {
    Springs springs;
    const Vector p = springs.minimize(infinite, infinite).value();
    EXPECT_LT((product(springs.pattern, springs.values, p) + springs.g).lpNorm<Eigen::Infinity>(), 1e-11);
    EXPECT_EQ(springs.solver.factorizations(), 1);
}

TEST(BoxQuadratic, RestsAtItsBoundsAndIsLevelBetween) {
    for (const double bound : {1e-3, 0.3, 2.0, 5.0, 20.0}) {
        Springs springs;
        const Vector p = springs.minimize(bound, 0.5 * bound).value();
        const Vector slope = springs.g + product(springs.pattern, springs.values, p);
        for (int i = 0; i < size; ++i) {
            SCOPED_TRACE(i);
            EXPECT_GE(p[i], -bound);
            EXPECT_LE(p[i], 0.5 * bound);
            // the first-order conditions, up to the solver's tolerance for forces of about one
            if (p[i] > -bound) {
                EXPECT_LE(slope[i], 1e-10);
            }
            if (p[i] < 0.5 * bound) {
                EXPECT_GE(slope[i], -1e-10);
            }
        }
    }
}

TEST(BoxQuadratic, WhatIsFixedStaysAndTheOthersFindTheirPlace) {
    Springs springs;
    Vector lower = Vector::Constant(size, -infinite), upper = Vector::Constant(size, infinite);
    lower[7] = upper[7] = 0;
    const Vector p = minimize_in_box(springs.pattern, springs.solver, springs.values, springs.g, lower, upper).value();
    EXPECT_EQ(p[7], 0);
    Vector slope = springs.g + product(springs.pattern, springs.values, p);
    slope[7] = 0;
    EXPECT_LT(slope.lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(BoxQuadratic, RefusesAHillTop) {
    EXPECT_FALSE(Springs(-3).minimize(1, 1));
    EXPECT_FALSE(Springs(-3).minimize(infinite, infinite));
}

}  // namespace box_quadratic_test
}  // namespace ripstop
