#pragma once

#include "ripstop/energy/spring_network.h"
#include "ripstop/model/plan/flattening.h"

namespace ripstop {

struct SpringMassOptions {
    int max_steps = 200000;          ///< > 0
    double damping = 0.5;            ///< fraction of critical damping at the highest frequency, in (0, 1]
    double step = 1.2;               ///< time step times the highest frequency, in (0, 2): stable below 2
    bool adaptive = false;           ///< increase the step while the total energy falls, halve it when it rises
    double energy_tolerance = 1e-5;  ///< at rest if a swing lowers the energy by less than this fraction, > 0
};

/// The result of the spring relaxation and its effort.
struct SpringMassRun {
    Points2 positions;     ///< #V x 2 [m]
    SolveSummary summary;  ///< its iterations are time steps, repeated ones included
    double energy = 0;     ///< energy of the springs at the end [J]
    int halvings = 0;      ///< number of step halvings because of instability
};

/// The paper's fine tuning: particles and springs in the plane, integrated by the explicit midpoint rule from `start`
/// (#V x 2) to rest.
///
///     x_m = x + h/2 v,  v_m = v + h/2 a(x, v);   x <- x + h v_m,  v <- v + h a(x_m, v_m)
///
/// The damping of a spring is tau k with tau = 2 damping / frequency bound, so the step h = step / frequency bound
/// lies in the stability region of the midpoint rule for every mode. This hardly damps low modes. Therefore the
/// velocities are dropped when the energy of the springs starts to rise again, which ends a swing. The paper's
/// criterion, "the energy stops decreasing", applies to whole swings; within a swing it would hold at the first
/// turning point.
///
/// Instability is detected by the total energy, which damping can only lower: a step that raises it, or produces a
/// number that is not finite, is undone and repeated from rest with half the step. Cost: two passes over the edges
/// per step.
SpringMassRun relax_spring_mass(const SpringNetwork& network, const Points2& start,
                                const SpringMassOptions& options = {});

}  // namespace ripstop
