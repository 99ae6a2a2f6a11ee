#include "ripstop/flatten/seam/seam_step.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace ripstop {
namespace {

constexpr double edge_weight = 1e6;  ///< rho, relative to the mean stiffness of the cloth
constexpr int max_attempts = 16;
constexpr int max_rest_shifts = 6;       // shifts near rest before the elements are clamped
constexpr double least_shift = 1e-7;     // relative to the mean stiffness
constexpr int max_updates = 20;          // normally a few; more if an edge belongs to a needle as stiff as rho
constexpr double short_edge = 0.01;      // relative to the mean boundary edge
constexpr int columns_at_once = 64;      // right-hand sides per solve in `edge_stiffness`, limited by the cache
constexpr double edge_tolerance = 1e-4;  // relative to the edges' errors: Newton itself leaves an error of second order
constexpr double rounding = 1e-13;       // relative to the lengths: smaller errors cannot be corrected

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
    lambda_ = lambda;
    edge_residual_ = problem_.edge_residual(u);
    dense_residual_ = problem_.dense_residual(u);
    near ? (clamped_ = false) : (shift_ = 0);
    // far from rest: exact, clamped, clamped and shifted; near rest: exact, shifted, which keeps the convergence fast
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
        const bool clamp = near ? attempt > max_rest_shifts : clamped_ || attempt > 0;
        if (attempt > (near || clamped_ ? 0 : 1)) shift_ = std::max(least_shift, 10 * shift_);
        if (near && attempt == max_rest_shifts + 1) shift_ = 0;
        energy_ = problem_.assemble(u, lambda, mu, rho_, clamp ? Curvature::semidefinite : Curvature::exact, gradient_,
                                    values_);
        hold_still();
        for (int i = 0; shift_ > 0 && i < problem_.unknowns(); ++i)
            values_[problem_.pattern().diagonal_slot(i)] += shift_ * problem_.stiffness();
        if (!solver_.factorize(values_) || solver_.inertia().negative > 0 || !border()) continue;
        exact_ = !clamp && shift_ == 0;
        // if the first attempt succeeded, try less modification next time
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

/// Solves for the columns of grain, area and the rotation constraint, and forms their Schur complement. They are
/// solved together with the Newton step's right-hand side, because reading the factor takes longer than using it. The
/// rotation constraint makes the matrix regular and is removed exactly afterwards. Returns false if the inertia is
/// not that of a minimum.
bool SeamStep::border() {
    const int k = problem_.dense_count();
    columns_.setZero(problem_.unknowns(), k + 1);
    columns_.leftCols(k) = problem_.dense_rows(u_);
    columns_(held_turn_, k) = std::sqrt(problem_.stiffness());
    Eigen::MatrixXd right(problem_.unknowns(), k + 2);
    right << columns_, right_side(gradient_, lambda_, edge_residual_);
    const Eigen::MatrixXd solved = solver_.solve_columns(right);
    solved_ = solved.leftCols(k + 1);
    first_ = solved.col(k + 1);
    schur_ = columns_.transpose() * solved_;
    schur_(k, k) -= 1;
    // the leading block is positive, so the sign of the determinant shows k positive and one negative direction
    return schur_.determinant() < 0;
}

Eigen::VectorXd SeamStep::right_side(const Eigen::VectorXd& g, const Eigen::VectorXd& lambda,
                                     const Eigen::VectorXd& c) const {
    if (!hold_edges_) return -g;
    return -g - problem_.edge_transposed(u_, lambda + rho_ * c);
}

void SeamStep::add_border(const Eigen::VectorXd& r, Solution& solution) const {
    Eigen::VectorXd target = columns_.transpose() * solution.d;
    target.head(r.size()) += r;
    const Eigen::VectorXd s = schur_.partialPivLu().solve(target);
    solution.d -= solved_ * s;
    solution.mu = s.head(r.size());
}

/// Iterates the multipliers from the first solve until the edges are correct to first order.
void SeamStep::update_multipliers(const Eigen::VectorXd& g, const Eigen::VectorXd& c, const Eigen::VectorXd& r,
                                  Solution& solution) const {
    add_border(r, solution);
    if (!hold_edges_) return;
    const double target =
        std::max(edge_tolerance * c.lpNorm<Eigen::Infinity>(), rounding * problem_.lengths().maxCoeff());
    // an error that is small for the other edges could tear a much shorter one
    const Eigen::VectorXd weight = (short_edge * problem_.lengths().mean() / problem_.lengths().array()).max(1.0);
    for (int update = 0; update < max_updates; ++update) {
        const Eigen::VectorXd missing = problem_.edge_product(u_, solution.d) + c;
        solution.lambda += rho_ * missing;
        if (missing.cwiseProduct(weight).lpNorm<Eigen::Infinity>() <= target) break;
        solution.d = solver_.solve(right_side(g, solution.lambda, c));
        add_border(r, solution);
    }
}

SeamStep::Solution SeamStep::step() const {
    Solution solution{first_, lambda_, {}};
    update_multipliers(gradient_, edge_residual_, dense_residual_, solution);
    return solution;
}

SeamStep::Solution SeamStep::correction(const Eigen::VectorXd& g, const Eigen::VectorXd& c,
                                        const Eigen::VectorXd& r) const {
    Solution solution{{}, Eigen::VectorXd::Zero(problem_.edge_count()), {}};
    solution.d = solver_.solve(right_side(g, solution.lambda, c));
    update_multipliers(g, c, r, solution);
    return solution;
}

Eigen::MatrixXd SeamStep::edge_stiffness() const {
    // K = H + rho JᵀJ is factorised, and J K⁻¹ Jᵀ = (S + rho I)⁻¹
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
