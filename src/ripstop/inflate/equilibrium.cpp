#include "ripstop/inflate/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ripstop/numeric/symmetric_solver.h"

namespace ripstop {
namespace {

struct Norms {
    double rms = 0, max = 0;
    Norms(const Eigen::VectorXd& gradient, double unit)
        : rms(gradient.norm() / std::sqrt(std::max<double>(1, static_cast<double>(gradient.size()))) / unit),
          max(gradient.size() == 0 ? 0 : gradient.cwiseAbs().maxCoeff() / unit) {}
    bool within(double tolerance) const { return rms < tolerance && max < 10 * tolerance; }
};

constexpr int steps_looked_at = 10;
constexpr double settled_force = 0.5;  // root mean square, in the unit of the tolerance

double size_of(const Points3& nodes) {
    return (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).norm();
}

/// Newton's method at one residual stiffness.
class Descent {
  public:
    Descent(const Balance& balance, Points3 start, const EquilibriumOptions& options, SolveSummary& summary)
        : balance_(balance),
          options_(options),
          summary_(summary),
          solver_(balance.pattern()),
          nodes_(std::move(start)),
          unit_(force_unit(balance, nodes_)),
          cap_(0.05 * size_of(nodes_)) {}

    /// Iterates until `tolerance` is met (true), no step succeeds, or the iterations are used up.
    bool run(double tolerance) {
        energy_ = balance_.assemble(nodes_, gradient_, values_);
        while (true) {
            const Norms norms(gradient_, unit_);
            if (options_.progress) report(norms, tolerance);
            if (norms.within(tolerance)) return true;
            if (steps_ == steps_looked_at && has_settled()) return true;
            if (summary_.iterations >= options_.iterations) return false;
            ++summary_.iterations;
            if (!factorize()) return false;
            const Eigen::VectorXd step = -solver_.solve(gradient_);
            if (!step.allFinite() || !advance(step)) {
                // The quadratic model is poor: repeat with a larger shift.
                if (shift_ > 1e3 * scale_) return false;
                shift_ = std::max(16 * shift_, 1e-4 * scale_);
            }
        }
    }

    const Points3& nodes() const { return nodes_; }
    double energy() const { return energy_; }
    const Eigen::VectorXd& gradient() const { return gradient_; }
    double unit() const { return unit_; }
    bool is_settled() const { return is_settled_; }

    /// Whether the Hessian at the present point is positive definite without a shift.
    bool is_stable() {
        ++summary_.factorizations;
        return solver_.factorize(values_) && solver_.inertia().negative == 0;
    }

  private:
    /// Whether the shape has settled since the last call.
    bool has_settled() {
        const bool has_before = before_.rows() > 0;
        const double moved = has_before ? (nodes_ - before_).norm() / std::sqrt(static_cast<double>(nodes_.rows())) : 0;
        const double fall = energy_before_ - energy_;
        steps_ = 0;
        before_ = nodes_;
        energy_before_ = energy_;
        is_settled_ = has_before && moved < options_.settled * size_of(nodes_) && fall < 5e-7 * std::abs(energy_) &&
                      Norms(gradient_, unit_).rms < settled_force;
        return is_settled_;
    }

    bool factorize() {
        scale_ = 0;
        const int n = balance_.unknowns();
        for (int i = 0; i < n; ++i) scale_ += std::abs(values_[balance_.pattern().diagonal_slot(i)]) / n;
        for (int attempt = 0; attempt < 40; ++attempt) {
            Eigen::VectorXd shifted = values_;
            for (int i = 0; i < n; ++i) shifted[balance_.pattern().diagonal_slot(i)] += shift_;
            ++summary_.factorizations;
            if (solver_.factorize(shifted) && solver_.inertia().negative == 0) return true;
            shift_ = std::max(4 * shift_, 1e-6 * scale_);
        }
        return false;
    }

    bool advance(const Eigen::VectorXd& step) {
        const double slope = gradient_.dot(step), longest = balance_.longest(step);
        if (!(slope < 0)) return false;
        double length = std::min(1.0, cap_ / longest);
        const bool is_capped = length < 1;
        for (int halving = 0; halving < 12; ++halving, length *= 0.5) {
            const Points3 next = balance_.moved(nodes_, length * step);
            const double energy = balance_.energy(next);
            const double change = energy - energy_;
            const bool descends = change <= 1e-4 * length * slope;
            const bool is_rounding = std::abs(change) < 1e-10 * std::abs(energy_);
            if (!descends && !is_rounding) continue;
            Eigen::VectorXd gradient, values;
            const double new_energy = balance_.assemble(next, gradient, values);
            if (!descends && gradient.norm() >= gradient_.norm()) continue;
            ++steps_;
            nodes_ = next;
            energy_ = new_energy;
            gradient_.swap(gradient);
            values_.swap(values);
            if (halving == 0 && !is_capped)
                shift_ = shift_ < 1e-9 * scale_ ? 0 : 0.25 * shift_;
            else if (halving > 2)
                shift_ = std::max(4 * shift_, 1e-6 * scale_);
            return true;
        }
        return false;
    }

    void report(const Norms& norms, double tolerance) {
        if (most_ == 0) most_ = std::max(norms.rms, 10 * tolerance);
        const double done = std::log(most_ / std::max(norms.rms, tolerance)) / std::log(most_ / tolerance);
        options_.progress(std::clamp(done, 0.0, 1.0),
                          fmt::format("step {}, forces {:.1e}", summary_.iterations, norms.rms));
    }

    const Balance& balance_;
    const EquilibriumOptions& options_;
    SolveSummary& summary_;
    SymmetricSolver solver_;
    Points3 nodes_;
    Points3 before_;
    bool is_settled_ = false;
    int steps_ = 0;  // steps taken since `before_`
    double unit_, cap_, energy_before_ = 0, energy_ = 0, scale_ = 1, shift_ = 0, most_ = 0;
    Eigen::VectorXd gradient_, values_;
};

constexpr int relaxation_steps = 4000, rounds = 3;

}  // namespace

double force_unit(const Balance& balance, const Points3& nodes) {
    const SewnEnvelope& sewn = balance.sewn();
    double edges = 0;
    for (int t = 0; t < static_cast<int>(sewn.triangles.rows()); ++t) {
        const auto x = balance.corners(nodes, t);
        edges += ((x[1] - x[0]).norm() + (x[2] - x[1]).norm() + (x[0] - x[2]).norm()) / 3;
    }
    const double edge = edges / std::max<double>(1, static_cast<double>(sewn.triangles.rows()));
    const double pressure = std::max(std::abs(balance.gas().at(nodes.col(2).maxCoeff())),
                                     std::abs(balance.gas().at(nodes.col(2).minCoeff())));
    return std::max(pressure, 1e-6) * edge * edge;
}

Equilibrium find_equilibrium(Balance& balance, const Points3& start, const EquilibriumOptions& options) {
    Equilibrium result;
    result.nodes = start;
    bool has_converged = false, has_settled = false;
    for (std::size_t stage = 0; stage < options.residuals.size(); ++stage) {
        balance.set_residual(options.residuals[stage]);
        const bool is_last = stage + 1 == options.residuals.size();
        for (int round = 0; round < rounds; ++round) {
            Descent descent(balance, result.nodes, options, result.summary);
            has_converged = descent.run(is_last ? options.tolerance : 100 * options.tolerance);
            has_settled = descent.is_settled();
            result.nodes = descent.nodes();
            result.energy = descent.energy();
            const Norms norms(descent.gradient(), descent.unit());
            result.residual = norms.rms;
            result.residual_max = norms.max;
            if (has_converged && is_last) result.is_stable = descent.is_stable();
            if (has_converged || result.summary.iterations >= options.iterations || round + 1 == rounds) break;
            const Equilibrium relaxed = relax_dynamically(balance, result.nodes, relaxation_steps, options.tolerance);
            if (relaxed.energy < result.energy) result.nodes = relaxed.nodes;
            // Continue from an equilibrium with more compressive stiffness.
            balance.set_residual(100 * options.residuals[stage]);
            Descent eased(balance, result.nodes, options, result.summary);
            eased.run(100 * options.tolerance);
            result.nodes = eased.nodes();
            balance.set_residual(options.residuals[stage]);
        }
    }
    result.summary.termination = has_converged ? Termination::converged : Termination::iteration_limit;
    result.summary.reason =
        has_settled ? fmt::format(
                          "ten steps moved it by less than {:.0e} of its size, forces out of balance by {:.1e} of "
                          "pressure times edge squared",
                          options.settled, result.residual)
        : has_converged
            ? fmt::format("forces in balance to {:.1e} of pressure times edge squared", result.residual)
            : fmt::format("forces out of balance by {:.1e} of pressure times edge squared", result.residual);
    return result;
}

Equilibrium relax_dynamically(const Balance& balance, const Points3& start, int steps, double tolerance) {
    Equilibrium result;
    result.nodes = start;
    const double unit = force_unit(balance, start);
    const Eigen::VectorXd masses = balance.fictitious_masses(start, 1.0);
    Eigen::VectorXd speed = Eigen::VectorXd::Zero(balance.unknowns()), gradient;
    double kinetic = 0;
    for (int step = 0; step < steps; ++step) {
        gradient = balance.gradient(result.nodes);
        ++result.summary.iterations;
        if (Norms(gradient, unit).within(tolerance)) break;
        speed -= gradient.cwiseQuotient(masses);
        const double now = 0.5 * speed.dot(masses.cwiseProduct(speed));
        if (now < kinetic) {
            speed.setZero();
            kinetic = 0;
            continue;
        }
        kinetic = now;
        result.nodes = balance.moved(result.nodes, speed);
    }
    gradient = balance.gradient(result.nodes);
    const Norms norms(gradient, unit);
    result.energy = balance.energy(result.nodes);
    result.residual = norms.rms;
    result.residual_max = norms.max;
    result.summary.termination = norms.within(tolerance) ? Termination::converged : Termination::iteration_limit;
    result.summary.reason = fmt::format("forces {:.1e} of pressure times edge squared", norms.rms);
    return result;
}

}  // namespace ripstop
