#include "ripstop/numeric/box_quadratic.h"

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr int max_rounds = 100;
constexpr double at_rest = 1e-12;  // relative to the largest entry of g

/// The matrix with the rows and columns of active unknowns reduced to their diagonal.
Vector without(const SparsePattern& pattern, const Vector& values, const std::vector<bool>& rests) {
    Vector kept = values;
    for (int c = 0; c < pattern.size(); ++c)
        for (int s = pattern.diagonal_slot(c) + 1; s < pattern.column_start()[static_cast<std::size_t>(c) + 1]; ++s)
            if (rests[at(c)] || rests[at(pattern.rows()[at(s)])]) kept[s] = 0;
    return kept;
}

}  // namespace

Vector free_gradient(const Vector& g, const Vector& x, const Vector& lower, const Vector& upper) {
    return Vector::NullaryExpr(g.size(), [&](Eigen::Index i) {
        return (x[i] <= lower[i] && g[i] > 0) || (x[i] >= upper[i] && g[i] < 0) ? 0 : g[i];
    });
}

std::optional<Vector> minimize_in_box(const SparsePattern& pattern, SymmetricSolver& solver, const Vector& values,
                                      const Vector& g, const Vector& lower, const Vector& upper) {
    Vector p = Vector::Zero(g.size());
    std::vector<bool> rests(static_cast<std::size_t>(g.size())), rested;
    for (int round = 0; round < max_rounds; ++round) {
        const Vector slope = g + product(pattern, values, p);
        const Vector open = free_gradient(slope, p, lower, upper);
        if (round > 0 && open.lpNorm<Eigen::Infinity>() <= at_rest * g.lpNorm<Eigen::Infinity>()) break;
        for (Eigen::Index i = 0; i < p.size(); ++i) rests[at(i)] = open[i] == 0 && slope[i] != 0;
        if (rests != rested) {
            if (!solver.factorize(without(pattern, values, rests)) || solver.inertia().negative > 0)
                return std::nullopt;
            rested = rests;
        }
        const Vector step = solver.solve(-open);
        double length = 1;
        Vector moved;
        for (int halving = 0; halving < 40; ++halving, length *= 0.5) {
            moved = (p + length * step).cwiseMax(lower).cwiseMin(upper) - p;
            if (slope.dot(moved) + 0.5 * moved.dot(product(pattern, values, moved)) <= 1e-4 * open.dot(moved)) break;
            moved.setZero();
        }
        if (moved.isZero(0)) break;
        p += moved;
    }
    return p;
}

}  // namespace ripstop
