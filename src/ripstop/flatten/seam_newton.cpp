#include "ripstop/flatten/seam_newton.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

/// One factorised Newton system; solves it for any residuals.
class NewtonSystem {
  public:
    NewtonSystem(const SeamProblem& problem, bool hold_edges)
        : problem_(problem), solver_(problem.pattern()), hold_edges_(hold_edges), rho_(hold_edges ? 1e4 * problem.stiffness() : 0) {}

    int factorizations() const { return solver_.factorizations(); }
    bool exact() const { return exact_; }

    /// Assembles and factorises at u; adds to the Hessian what it takes to make it positive definite along the constraints.
    /// False where no amount does.
    bool factorize(const Vector& u, const Vector& lambda, const Vector& mu) {
        u_ = u;
        const double unit = problem_.stiffness();
        for (int attempt = 0; attempt < 12; ++attempt) {
            const Curvature curvature = clamp_ > 0 || attempt > 0 ? Curvature::semidefinite : Curvature::exact;
            energy_ = problem_.assemble(u, lambda, mu, rho_, curvature, gradient_, values_);
            hold_still(u, unit);
            if (attempt > 1) {
                shift_ = std::max(1e-6, 6 * shift_);
                for (int i = 0; i < problem_.unknowns(); ++i) values_[problem_.pattern().diagonal_slot(i)] += shift_ * unit;
            }
            if (solver_.factorize(values_) && solver_.inertia().negative == 0 && border(u, unit)) {
                exact_ = curvature == Curvature::exact;
                clamp_ = exact_ ? 0 : std::max(0, attempt == 0 ? clamp_ - 1 : 1);
                shift_ /= 3;
                return true;
            }
        }
        return false;
    }

    double energy() const { return energy_; }
    const Vector& gradient() const { return gradient_; }

    struct Step {
        Vector d, lambda, mu;
    };

    /// d and the new multipliers for the gradient g and residuals c (edges) and r (grain, area), starting from lambda.
    Step solve(const Vector& g, const Vector& c, const Vector& r, const Vector& lambda) const {
        Step step{{}, lambda, {}};
        const double target = 1e-7 * c.lpNorm<Eigen::Infinity>();
        for (int pass = 0; pass < 8; ++pass) {
            Vector right = -g;
            if (hold_edges_) right -= problem_.edge_transposed(u_, step.lambda + rho_ * c);
            solve_bordered(right, r, step);
            if (!hold_edges_) break;
            const Vector missing = problem_.edge_product(u_, step.d) + c;
            step.lambda += rho_ * missing;
            if (missing.lpNorm<Eigen::Infinity>() <= target) break;
        }
        return step;
    }

  private:
    void hold_still(const Vector& u, double unit) {
        const int v = problem_.held_vertex();
        held_turn_ = problem_.held_turn(u);
        for (const int i : {2 * v, 2 * v + 1, held_turn_}) values_[problem_.pattern().diagonal_slot(i)] += unit;
    }

    /// The columns of grain, area and the hold against turning, and their Schur complement. The hold is taken out again
    /// exactly: it was there to make the matrix regular. False where the inertia is not that of a minimum.
    bool border(const Vector& u, double unit) {
        const Eigen::MatrixXd rows = problem_.dense_rows(u);
        const int k = problem_.dense_count();
        columns_.setZero(problem_.unknowns(), k + 1);
        columns_.leftCols(k) = rows;
        columns_(held_turn_, k) = std::sqrt(unit);
        solved_ = solver_.solve_columns(columns_);
        Eigen::MatrixXd schur = columns_.transpose() * solved_;
        schur(k, k) -= 1;
        schur_.compute(schur);
        // k positive and one negative direction: the sign of the determinant tells, as the leading block is positive
        return schur.determinant() < 0;
    }

    void solve_bordered(const Vector& right, const Vector& r, Step& step) const {
        step.d = solver_.solve(right);
        Vector target = columns_.transpose() * step.d;
        target.head(r.size()) += r;
        const Vector s = schur_.solve(target);
        step.d -= solved_ * s;
        step.mu = s.head(r.size());
    }

    const SeamProblem& problem_;
    SymmetricSolver solver_;
    bool hold_edges_;
    double rho_;
    Vector u_, gradient_, values_;
    double energy_ = 0;
    int held_turn_ = 0;
    Eigen::MatrixXd columns_, solved_;
    Eigen::FullPivLU<Eigen::MatrixXd> schur_;
    int clamp_ = 0;      ///< how many iterations more to start from clamped Hessians
    double shift_ = 0;
    bool exact_ = false;
};

class Search {
  public:
    Search(const SeamProblem& problem, const SeamNewtonOptions& options) : problem_(problem), options_(options) {}

    double infeasibility(const Vector& u) const {
        return (options_.hold_edges ? problem_.edge_residual(u).lpNorm<1>() : 0) + problem_.dense_residual(u).lpNorm<1>();
    }

    /// Moves u along the step, or along it and its correction; the length of the step taken, 0 where none helps.
    double move(const NewtonSystem& system, const NewtonSystem::Step& step, Vector& u) {
        const double largest = std::max(options_.hold_edges ? step.lambda.lpNorm<Eigen::Infinity>() : 0,
                                        step.mu.lpNorm<Eigen::Infinity>());
        weight_ = std::max(weight_, 1.2 * largest);
        const double before = infeasibility(u);
        const double merit = system.energy() + weight_ * before;
        const double slope = system.gradient().dot(step.d) - weight_ * before;
        const double noise = 1e-13 * (std::abs(merit) + problem_.stiffness() * 1e-6 * problem_.size() * problem_.size());
        double length = std::min(1.0, problem_.longest_step(u, step.d));
        for (int halving = 0; halving < 30; ++halving, length *= 0.5) {
            const auto accepted = [&](const Vector& at) {
                return problem_.energy(at) + weight_ * infeasibility(at) <= merit + 1e-4 * length * std::min(slope, 0.0) + noise;
            };
            const Vector trial = u + length * step.d;
            if (accepted(trial)) {
                u = trial;
                return length;
            }
            if (halving == 0 && length > 0.99) {
                const Vector zero = Vector::Zero(problem_.unknowns());
                const auto correction =
                    system.solve(zero, problem_.edge_residual(trial), problem_.dense_residual(trial), Vector::Zero(problem_.edge_count()));
                const Vector corrected = trial + correction.d;
                if (problem_.longest_step(u, corrected - u) > 0.99 && accepted(corrected)) {
                    u = corrected;
                    return 1;
                }
            }
        }
        return 0;
    }

  private:
    const SeamProblem& problem_;
    const SeamNewtonOptions& options_;
    double weight_ = 0;
};

}  // namespace

SeamSolution minimize_with_seams(const SeamProblem& problem, const Vector& start, const SeamNewtonOptions& options) {
    SeamSolution at;
    at.u = start;
    at.lambda = Vector::Zero(problem.edge_count());
    at.mu = Vector::Zero(problem.dense_count());
    NewtonSystem system(problem, options.hold_edges);
    Search search(problem, options);
    const double force_scale = problem.stiffness() * problem.lengths().mean();
    at.summary = {Termination::iteration_limit, 0, 0, "the forces were not yet in balance"};
    if (!std::isfinite(problem.energy(start))) {
        at.summary = {Termination::failed, 0, 0, "the start has triangles turned over"};
        return at;
    }
    while (true) {
        const Vector g = problem.gradient(at.u);
        Vector residual = g + problem.dense_rows(at.u) * at.mu;
        if (options.hold_edges) residual += problem.edge_transposed(at.u, at.lambda);
        at.force_residual = residual.lpNorm<Eigen::Infinity>() / force_scale;
        at.length_residual =
            options.hold_edges ? problem.edge_residual(at.u).cwiseQuotient(problem.lengths()).lpNorm<Eigen::Infinity>() : 0;
        const double dense = problem.dense_residual(at.u).lpNorm<Eigen::Infinity>() / problem.size();
        if (at.force_residual <= options.force_tolerance && at.length_residual <= options.length_tolerance &&
            dense <= options.length_tolerance) {
            at.summary.termination = Termination::converged;
            at.summary.reason = "forces in balance";
            at.strict_minimum = at.summary.iterations > 0 && system.exact();
            break;
        }
        if (at.summary.iterations == options.max_iterations) break;
        ++at.summary.iterations;
        if (!system.factorize(at.u, at.lambda, at.mu)) {
            at.summary.termination = Termination::stagnated;
            at.summary.reason = "no shift makes the Newton system positive definite";
            break;
        }
        const auto step = system.solve(system.gradient(), problem.edge_residual(at.u), problem.dense_residual(at.u), at.lambda);
        const double length = search.move(system, step, at.u);
        if (length == 0) {
            at.summary.termination = Termination::stagnated;
            at.summary.reason = "no step improves energy and lengths together";
            break;
        }
        at.lambda += length * (step.lambda - at.lambda);
        at.mu += length * (step.mu - at.mu);
    }
    at.summary.factorizations = system.factorizations();
    at.energy = problem.energy(at.u);
    return at;
}

}  // namespace ripstop
