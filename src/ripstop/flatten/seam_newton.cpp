#include "ripstop/flatten/seam_newton.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/flatten/seam_step.h"

namespace ripstop {
namespace {

using Vector = Eigen::VectorXd;

constexpr double near_rest = 1e-4;  ///< of the lengths: from here on the Hessian is to be bent as little as possible

class Search {
  public:
    Search(const SeamProblem& problem, const SeamNewtonOptions& options) : problem_(problem), options_(options) {}

    double infeasibility(const Vector& u) const {
        return (options_.hold_edges ? problem_.edge_residual(u).lpNorm<1>() : 0) +
               problem_.dense_residual(u).lpNorm<1>();
    }

    /// Moves u along the step, or along it and its correction; the length of the step taken, 0 where none helps.
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
                const auto correction =
                    system.correction(problem_.edge_residual(trial), problem_.dense_residual(trial));
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
    const double force_scale = problem.stiffness() * problem.lengths().mean();
    at.summary = {Termination::iteration_limit, 0, 0, "the forces were not yet in balance"};
    if (!std::isfinite(problem.energy(start.u))) {
        at.summary = {Termination::failed, 0, 0, "the start has triangles turned over"};
        return at;
    }
    while (true) {
        const Vector g = problem.gradient(at.u);
        Vector residual = g + problem.dense_rows(at.u) * at.mu;
        if (options.hold_edges) residual += problem.edge_transposed(at.u, at.lambda);
        at.force_residual = residual.lpNorm<Eigen::Infinity>() / force_scale;
        at.length_residual =
            options.hold_edges ? problem.edge_residual(at.u).cwiseQuotient(problem.lengths()).lpNorm<Eigen::Infinity>()
                               : 0;
        const double dense = problem.dense_residual(at.u).lpNorm<Eigen::Infinity>() / problem.size();
        if (at.force_residual <= options.force_tolerance && at.length_residual <= options.length_tolerance &&
            dense <= options.length_tolerance) {
            at.summary.termination = Termination::converged;
            at.summary.reason = "forces in balance";
            // the last factorisation was one step before; one more only where there was none, or it was helped
            at.strict_minimum =
                options.hold_edges && ((at.summary.iterations > 0 && system.exact()) ||
                                       (system.factorize(at.u, at.lambda, at.mu, true) && system.exact()));
            break;
        }
        if (at.summary.iterations == options.max_iterations) break;
        ++at.summary.iterations;
        const bool near = options.hold_edges && at.length_residual < near_rest;
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
    }
    at.summary.factorizations = system.factorizations() - spent;
    at.energy = problem.energy(at.u);
    return at;
}

}  // namespace ripstop
