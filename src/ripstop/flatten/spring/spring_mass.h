#pragma once

#include "ripstop/energy/spring_network.h"
#include "ripstop/model/plan/flattening.h"

namespace ripstop {

struct SpringMassOptions {
    int max_steps = 200000;          ///< > 0
    double damping = 0.5;            ///< share of critical damping at the fastest frequency, in (0, 1]
    double step = 1.2;               ///< time step times the fastest frequency, in (0, 2): stable below 2
    bool adaptive = false;           ///< let the step grow while the total energy falls, halve it when it rises
    double energy_tolerance = 1e-5;  ///< at rest when one swing lowers the energy by a smaller share, > 0
};

/// What the fine tuning took, beside its result.
struct SpringMassRun {
    Points2 positions;     ///< #V x 2 [m]
    SolveSummary summary;  ///< iterations: time steps, redone ones included
    double energy = 0;     ///< of the springs at the end [J]
    int halvings = 0;      ///< of the step, where an instability was caught
};

/// The paper's fine tuning: particles and springs in the plane, integrated by the explicit midpoint rule from `start`
/// (#V x 2) until the energy is at rest.
///
///     x_m = x + h/2 v,  v_m = v + h/2 a(x, v);   x <- x + h v_m,  v <- v + h a(x_m, v_m)
///
/// The damper of a spring is tau k, tau = 2 damping / frequency bound, so the step h = step / frequency bound is inside
/// the midpoint rule's stability region for every mode. Low modes are hardly damped that way: when the springs' energy
/// starts to rise again the velocities are dropped, which ends one swing. The paper's stop, "the energy stops
/// decreasing", is asked of whole swings, as within one it would fire at the first turning point.
///
/// Instability is caught by the total energy, which dampers can only lower: a step that raises it, or leaves finite
/// numbers, is undone and redone from rest with half the step. Cost: two passes over the edges a step.
SpringMassRun relax_spring_mass(const SpringNetwork& network, const Points2& start,
                                const SpringMassOptions& options = {});

}  // namespace ripstop
