#include "ripstop/flatten/spring/spring_mass.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/error.h"

namespace ripstop {
namespace {

struct State {
    Points2 x, v, force;
    double potential = 0;
    double kinetic = 0;

    double total() const { return potential + kinetic; }
};

class Integrator {
  public:
    Integrator(const SpringNetwork& network, double tau) : network_(network), tau_(tau) {
        inverse_mass_ = network.mass.cwiseInverse();
    }

    void evaluate(State& state) const {
        state.potential = energy_and_forces(network_, state.x, state.v, tau_, state.force);
        state.kinetic = 0.5 * network_.mass.dot(state.v.rowwise().squaredNorm());
    }

    /// One midpoint step of length h from `from` to `to`.
    void step(const State& from, double h, State& to) {
        middle_.x = from.x + 0.5 * h * from.v;
        middle_.v = from.v + 0.5 * h * (from.force.array().colwise() * inverse_mass_.array()).matrix();
        energy_and_forces(network_, middle_.x, middle_.v, tau_, middle_.force);
        to.x = from.x + h * middle_.v;
        to.v = from.v + h * (middle_.force.array().colwise() * inverse_mass_.array()).matrix();
        evaluate(to);
    }

  private:
    const SpringNetwork& network_;
    double tau_;
    Eigen::VectorXd inverse_mass_;
    State middle_;
};

void require_valid(const SpringMassOptions& options) {
    if (options.max_steps <= 0 || !(options.damping > 0 && options.damping <= 1) ||
        !(options.step > 0 && options.step < 2) || !(options.energy_tolerance > 0))
        throw InputError("spring-mass options: max_steps > 0, damping in (0, 1], step in (0, 2), energy_tolerance > 0");
}

/// The energy of all springs stretched to twice their length: the scale for a zero energy.
double energy_scale(const SpringNetwork& network) {
    double sum = 0;
    for (const Spring& spring : network.springs) sum += 0.5 * spring.stiffness * spring.rest * spring.rest;
    return sum;
}

}  // namespace

SpringMassRun relax_spring_mass(const SpringNetwork& network, const Points2& start, const SpringMassOptions& options) {
    require_valid(options);
    const double frequency = frequency_bound(network);
    const double full_step = options.step / frequency;
    Integrator integrator(network, 2 * options.damping / frequency);
    const double scale = energy_scale(network);
    const double nothing = 1e-22 * scale;  // strains of 1e-11: an isometry
    constexpr double growth = 1.02;        // growth factor per step

    SpringMassRun run;
    State state{start, Points2::Zero(start.rows(), 2), {}};
    State next;
    integrator.evaluate(state);
    double h = full_step;
    double largest = options.adaptive ? std::numeric_limits<double>::infinity() : full_step;
    double swing_start = state.potential;
    int quiet_swings = 0;
    run.summary = {Termination::iteration_limit, 0, 0, "the energy was still falling"};
    while (run.summary.iterations < options.max_steps) {
        ++run.summary.iterations;
        integrator.step(state, h, next);
        const bool stable = std::isfinite(next.total()) && next.total() <= state.total() * (1 + 1e-9) + nothing;
        if (!stable) {
            ++run.halvings;
            largest = options.adaptive ? 0.8 * h : full_step;
            h *= 0.5;
            state.v.setZero();
            integrator.evaluate(state);
            if (h < 1e-9 * full_step) {
                run.summary.termination = Termination::stagnated;
                run.summary.reason = "no step lowers the energy at working precision";
                break;
            }
            continue;
        }
        const bool rising = next.potential > state.potential;
        if (rising) {  // end of a swing: drop the velocities where the energy was lowest
            const double gained = swing_start - state.potential;
            const bool quiet = gained <= options.energy_tolerance * state.potential + nothing;
            quiet_swings = quiet ? quiet_swings + 1 : 0;
            swing_start = state.potential;
            if (quiet_swings >= 3 || state.potential <= nothing) {
                run.summary.termination = Termination::converged;
                run.summary.reason = "energy at rest";
                break;
            }
            state.v.setZero();
            integrator.evaluate(state);
            continue;
        }
        std::swap(state, next);
        h = std::min(largest, growth * h);
    }
    run.positions = state.x;
    run.energy = state.potential;
    if (!std::isfinite(run.energy)) run.summary = {Termination::failed, run.summary.iterations, 0, "no finite energy"};
    return run;
}

}  // namespace ripstop
