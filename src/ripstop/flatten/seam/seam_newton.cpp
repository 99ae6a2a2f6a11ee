#include "ripstop/flatten/seam/seam_newton.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/flatten/seam/seam_step.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr double near_rest = 1e-4;  ///< relative to the lengths: below this the Hessian should be modified as little as
                                    ///< possible

class Search {
  public:
    Search(const SeamProblem& problem, const SeamNewtonOptions& options) : problem_(problem), options_(options) {}

    double infeasibility(const Vector& u) const {
        return (options_.hold_edges ? problem_.edge_residual(u).lpNorm<1>() : 0) +
               problem_.dense_residual(u).lpNorm<1>();
    }

    /// Moves u along the step, or along the step and its correction. Returns the step length, 0 if none helps.
    double move(const SeamStep& system, const SeamStep::Solution& step, Vector& u) {
        const double largest = std::max(options_.hold_edges ? step.lambda.lpNorm<Eigen::Infinity>() : 0,
                                        step.mu.lpNorm<Eigen::Infinity>());
        weight_ = std::max(weight_, 1.2 * largest);
        const double before = infeasibility(u);
        const double merit = system.energy() + weight_ * before;
        const double slope = system.gradient().dot(step.d) - weight_ * before;
        const double noise =
            1e-13 * (std::abs(merit) + problem_.stiffness() * 1e-6 * problem_.size() * problem_.size());
        double length = std::min(1.0, problem_.longest_step(u, step.d));
        for (int halving = 0; halving < 30; ++halving, length *= 0.5) {
            const auto accepted = [&](const Vector& at) {
                return problem_.energy(at) + weight_ * infeasibility(at) <=
                       merit + 1e-4 * length * std::min(slope, 0.0) + noise;
            };
            const Vector trial = u + length * step.d;
            if (accepted(trial)) {
                u = trial;
                return length;
            }
            if (halving == 0 && length > 0.99) {
                const auto correction = system.correction(
                    Vector::Zero(problem_.unknowns()), problem_.edge_residual(trial), problem_.dense_residual(trial));
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

SeamNewton::SeamNewton(const SeamProblem& problem) : problem_(problem), step_(std::make_unique<SeamStep>(problem)) {}
SeamNewton::~SeamNewton() = default;

/// The residuals of the first-order conditions, and their ratio to the tolerances.
class SeamNewton::ForceBalance {
  public:
    ForceBalance(const SeamProblem& problem, const SeamNewtonOptions& options, const SeamSolution& at)
        : force(problem.gradient(at.u) + problem.dense_rows(at.u) * at.mu),
          lengths(problem.edge_residual(at.u)),
          dense(problem.dense_residual(at.u)) {
        if (options.hold_edges) force += problem.edge_transposed(at.u, at.lambda);
        force_residual = force.lpNorm<Eigen::Infinity>() / (problem.stiffness() * problem.lengths().mean());
        if (options.hold_edges)
            length_residual = lengths.cwiseQuotient(problem.length_scales()).lpNorm<Eigen::Infinity>();
        excess = std::max({force_residual / options.force_tolerance, length_residual / options.length_tolerance,
                           dense.lpNorm<Eigen::Infinity>() / problem.size() / options.length_tolerance});
        if (!std::isfinite(excess)) excess = std::numeric_limits<double>::infinity();
    }

    Vector force, lengths, dense;
    double force_residual = 0, length_residual = 0;
    double excess = 0;  ///< at most one if all tolerances are met
};

/// Continues with the present factorisation, at one solve per step, as long as each step gains a factor of ten.
SeamNewton::ForceBalance SeamNewton::settle(const SeamNewtonOptions& options, SeamSolution& at) const {
    ForceBalance balance(problem_, options, at);
    while (balance.excess > 1) {
        const SeamStep::Solution step = step_->correction(balance.force, balance.lengths, balance.dense);
        if (problem_.longest_step(at.u, step.d) < 0.99) break;
        SeamSolution next = at;
        next.u += step.d;
        next.lambda += step.lambda;
        next.mu += step.mu;
        const ForceBalance after(problem_, options, next);
        if (!(after.excess < balance.excess)) break;
        const bool fast = after.excess < 0.1 * balance.excess;
        at = std::move(next);
        balance = after;
        if (!fast) break;
    }
    return balance;
}

const SeamStep* SeamNewton::system_at(const SeamSolution& solution) {
    step_->hold_edges(true);
    return step_->factorize(solution.u, solution.lambda, solution.mu, true) ? step_.get() : nullptr;
}

SeamSolution SeamNewton::minimize(const Vector& start, const SeamNewtonOptions& options) {
    SeamSolution at;
    at.u = start;
    at.lambda = Vector::Zero(problem_.edge_count());
    at.mu = Vector::Zero(problem_.dense_count());
    return minimize(at, options);
}

SeamSolution SeamNewton::minimize(const SeamSolution& start, const SeamNewtonOptions& options) {
    const SeamProblem& problem = problem_;
    SeamStep& system = *step_;
    system.hold_edges(options.hold_edges);
    const int spent = system.factorizations();
    SeamSolution at;
    at.u = start.u;
    at.lambda = start.lambda;
    at.mu = start.mu;
    Search search(problem, options);
    at.summary = {Termination::iteration_limit, 0, 0, "the forces were not yet in balance"};
    if (!std::isfinite(problem.energy(start.u))) {
        at.summary = {Termination::failed, 0, 0, "the start has flipped triangles"};
        return at;
    }
    const bool goes_on = options.hold_edges && options.go_on && system.exact();
    ForceBalance balance = goes_on ? settle(options, at) : ForceBalance(problem, options, at);
    while (balance.excess > 1 && at.summary.iterations < options.max_iterations) {
        ++at.summary.iterations;
        const bool near = options.hold_edges && balance.length_residual < near_rest;
        if (!system.factorize(at.u, at.lambda, at.mu, near)) {
            at.summary.termination = Termination::stagnated;
            at.summary.reason = "no shift makes the Newton system positive definite";
            break;
        }
        const auto step = system.step();
        const double length = search.move(system, step, at.u);
        if (length == 0) {
            at.summary.termination = Termination::stagnated;
            at.summary.reason = "no step improves energy and lengths together";
            break;
        }
        at.lambda += length * (step.lambda - at.lambda);
        at.mu += length * (step.mu - at.mu);
        const bool settling = options.hold_edges && length == 1 && system.exact();
        balance = settling ? settle(options, at) : ForceBalance(problem, options, at);
    }
    if (balance.excess <= 1) {
        at.summary.termination = Termination::converged;
        at.summary.reason = "forces in balance";
        // factorise once more only if there is no factorisation yet, or if it was modified
        at.strict_minimum = options.hold_edges && (((goes_on || at.summary.iterations > 0) && system.exact()) ||
                                                   (system.factorize(at.u, at.lambda, at.mu, true) && system.exact()));
    }
    at.force_residual = balance.force_residual;
    at.length_residual = balance.length_residual;
    at.summary.factorizations = system.factorizations() - spent;
    at.energy = problem.energy(at.u);
    return at;
}

}  // namespace ripstop
