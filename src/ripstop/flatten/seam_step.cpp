#include "ripstop/flatten/seam_step.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double edge_weight = 1e4;  ///< rho, in mean stiffnesses of the cloth
constexpr int max_attempts = 16;
constexpr int max_shifts = 6;         // near rest, before the elements are clamped
constexpr double least_shift = 1e-7;  // in mean stiffnesses
constexpr int max_updates = 8;
constexpr int columns_at_once = 64;  // of a solve for every edge: what a cache holds

}  // namespace

SeamStep::SeamStep(const SeamProblem& problem) : problem_(problem), solver_(problem.pattern()) {
    hold_edges(true);
}

void SeamStep::hold_edges(bool hold) {
    hold_edges_ = hold;
    rho_ = hold ? edge_weight * problem_.stiffness() : 0;
    clamped_ = false;
    shift_ = 0;
}

bool SeamStep::factorize(const Eigen::VectorXd& u, const Eigen::VectorXd& lambda, const Eigen::VectorXd& mu,
                         bool near) {
    u_ = u;
    near ? (clamped_ = false) : (shift_ = 0);
    // far from rest: exact, clamped, clamped and shifted; near it: exact, shifted, which keeps the convergence fast
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
        const bool clamp = near ? attempt > max_shifts : clamped_ || attempt > 0;
        if (attempt > (near || clamped_ ? 0 : 1)) shift_ = std::max(least_shift, 10 * shift_);
        if (near && attempt == max_shifts + 1) shift_ = 0;
        energy_ = problem_.assemble(u, lambda, mu, rho_, clamp ? Curvature::semidefinite : Curvature::exact, gradient_,
                                    values_);
        hold_still();
        for (int i = 0; shift_ > 0 && i < problem_.unknowns(); ++i)
            values_[problem_.pattern().diagonal_slot(i)] += shift_ * problem_.stiffness();
        if (!solver_.factorize(values_) || solver_.inertia().negative > 0 || !border()) continue;
        exact_ = !clamp && shift_ == 0;
        // what went at once is tried with less next time
        clamped_ = clamp && attempt > 0;
        if (attempt == 0) shift_ = shift_ > least_shift ? 0.3 * shift_ : 0;
        return true;
    }
    return false;
}

void SeamStep::hold_still() {
    const int v = problem_.held_vertex();
    held_turn_ = problem_.held_turn(u_);
    for (const int i : {2 * v, 2 * v + 1, held_turn_})
        values_[problem_.pattern().diagonal_slot(i)] += problem_.stiffness();
}

/// The columns of grain, area and the hold against turning, and their Schur complement. The hold makes the matrix regular
/// and is taken out again exactly. False where the inertia is not that of a minimum.
bool SeamStep::border() {
    const int k = problem_.dense_count();
    columns_.setZero(problem_.unknowns(), k + 1);
    columns_.leftCols(k) = problem_.dense_rows(u_);
    columns_(held_turn_, k) = std::sqrt(problem_.stiffness());
    solved_ = solver_.solve_columns(columns_);
    schur_ = columns_.transpose() * solved_;
    schur_(k, k) -= 1;
    // the leading block is positive, so k positive and one negative direction show in the determinant's sign
    return schur_.determinant() < 0;
}

void SeamStep::solve_bordered(const Eigen::VectorXd& right, const Eigen::VectorXd& r, Solution& solution) const {
    solution.d = solver_.solve(right);
    Eigen::VectorXd target = columns_.transpose() * solution.d;
    target.head(r.size()) += r;
    const Eigen::VectorXd s = schur_.partialPivLu().solve(target);
    solution.d -= solved_ * s;
    solution.mu = s.head(r.size());
}

SeamStep::Solution SeamStep::solve(const Eigen::VectorXd& g, const Eigen::VectorXd& c, const Eigen::VectorXd& r,
                                   const Eigen::VectorXd& lambda) const {
    Solution solution{{}, lambda, {}};
    const double target = 1e-7 * c.lpNorm<Eigen::Infinity>();
    for (int update = 0; update < max_updates; ++update) {
        Eigen::VectorXd right = -g;
        if (hold_edges_) right -= problem_.edge_transposed(u_, solution.lambda + rho_ * c);
        solve_bordered(right, r, solution);
        if (!hold_edges_) break;
        const Eigen::VectorXd missing = problem_.edge_product(u_, solution.d) + c;
        solution.lambda += rho_ * missing;
        if (missing.lpNorm<Eigen::Infinity>() <= target) break;
    }
    return solution;
}

Eigen::MatrixXd SeamStep::edge_stiffness() const {
    // what is factorised is K = H + rho JᵀJ, and J K⁻¹ Jᵀ = (S + rho I)⁻¹
    const int count = problem_.edge_count();
    const Eigen::PartialPivLU<Eigen::MatrixXd> border(schur_);
    Eigen::MatrixXd softness(count, count);
    for (int first = 0; first < count; first += columns_at_once) {
        const int width = std::min(columns_at_once, count - first);
        Eigen::MatrixXd x(problem_.unknowns(), width);
        for (int k = 0; k < width; ++k)
            x.col(k) = problem_.edge_transposed(u_, Eigen::VectorXd::Unit(count, first + k));
        x = solver_.solve_columns(x);
        x -= solved_ * border.solve(columns_.transpose() * x).eval();
        for (int k = 0; k < width; ++k) softness.col(first + k) = problem_.edge_product(u_, x.col(k));
    }
    const Eigen::MatrixXd mean = 0.5 * (softness + softness.transpose());
    Eigen::MatrixXd stiffness = mean.llt().solve(Eigen::MatrixXd::Identity(count, count));
    stiffness.diagonal().array() -= rho_;
    return stiffness;
}

}  // namespace ripstop
