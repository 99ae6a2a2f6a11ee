#include "ripstop/design/natural/natural_shape.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

#include "ripstop/base/text/range.h"
#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

// Quantities are in units of b and the length `unit`; the unknowns are x = (load, mouth radius, th0).
struct Problem {
    MeridianEquation equation;
    double mouth_ratio;
    enum class Size { volume, diameter, load } size;
};

struct Shot {
    Meridian meridian;
    Vector3d residual;  ///< errors of the angle on the axis, the mouth ratio and the size
};

Shot shoot(const Problem& problem, const Vector3d& x) {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    Shot shot{{}, Vector3d::Constant(nowhere)};
    if (!x.allFinite() || !(x[0] > 0) || !(std::abs(x[2]) < 0.499 * pi)) return shot;
    MeridianPoint start;
    start.r = x[1];
    start.theta = x[2];
    start.tension = x[0] / std::cos(x[2]);
    shot.meridian = trace_meridian(problem.equation, start, 1);
    if (!shot.meridian.on_axis) return shot;
    const MeridianPoint top = shot.meridian.stations.back();
    const double radius = shot.meridian.equator().r;
    const double size = problem.size == Problem::Size::volume     ? top.volume
                        : problem.size == Problem::Size::diameter ? 2 * radius
                                                                  : x[0];
    shot.residual << top.theta + pi / 2, x[1] - problem.mouth_ratio * radius, size - 1;
    return shot;
}

struct Solution {
    Vector3d x;
    Shot shot;
    int iterations = 0;
    bool converged = false;
};

Eigen::Matrix3d jacobian(const Problem& problem, const Vector3d& x, const Vector3d& residual) {
    constexpr double nudge = 1e-7;
    Eigen::Matrix3d J;
    for (int k = 0; k < 3; ++k) {
        Vector3d moved = x;
        moved[k] += nudge;
        J.col(k) = (shoot(problem, moved).residual - residual) / nudge;
    }
    return J;
}

/// Newton's method with step halving from `start`.
Solution solve(const Problem& problem, const Vector3d& start) {
    constexpr double good_enough = 1e-9;  // the integrator's noise ends the descent well below this
    Solution now{start, shoot(problem, start)};
    for (; now.iterations < 40 && now.shot.residual.allFinite(); ++now.iterations) {
        if (now.shot.residual.norm() < 1e-13) break;
        const Eigen::Matrix3d J = jacobian(problem, now.x, now.shot.residual);
        const Vector3d step = -J.partialPivLu().solve(now.shot.residual);
        bool better = false;
        for (double part = 1; part > 1e-3 && !better && step.allFinite(); part /= 2) {
            Shot next = shoot(problem, now.x + part * step);
            better = next.residual.norm() < now.shot.residual.norm();
            if (!better) continue;
            now.x += part * step;
            now.shot = std::move(next);
        }
        if (!better) break;
    }
    now.converged = now.shot.residual.norm() < good_enough;
    return now;
}

/// The problem with a fraction of its weight and of its hoop tension: both vanish at 0.
Problem part_of(Problem problem, double part) {
    problem.equation.weight *= part;
    problem.equation.tape_weight *= part;
    if (problem.equation.bulge > 0 && part < 1)
        problem.equation.bulge = std::atan2(std::tan(problem.equation.bulge), part);
    return problem;
}

/// Approximates the weightless smooth shape, slimmer by the volume that the lobes add.
Vector3d first_guess(const Problem& problem) {
    const double q = problem.mouth_ratio;
    const double theta = (50 - 21 * q) * degree;
    if (problem.size == Problem::Size::diameter) return {0.5, 0.5 * q, theta};
    const MeridianEquation& e = problem.equation;
    const MeridianPoint wall{0, 1, 0, 0, 1, 0, 0};
    const double fuller = e.slope(wall).volume / pi;
    return {1, 0.635 * q / std::cbrt(fuller), theta};
}

Solution follow(const Problem& problem) {
    Solution solution = solve(problem, first_guess(problem));
    if (solution.converged) return solution;
    int iterations = solution.iterations;
    solution = solve(part_of(problem, 0), first_guess(part_of(problem, 0)));
    iterations += solution.iterations;
    double done = 0;
    double stride = 0.5;
    while (solution.converged && done < 1 && stride > 1e-3) {
        const double part = std::min(1.0, done + stride);
        Solution next = solve(part_of(problem, part), solution.x);
        iterations += next.iterations;
        if (next.converged) {
            solution = std::move(next);
            done = part;
        } else {
            stride /= 2;
        }
    }
    solution.iterations = iterations;
    solution.converged = solution.converged && done == 1;
    return solution;
}

void require_valid(const NaturalShapeOptions& o) {
    require_above("volume", o.volume, 0, "m3");
    if (o.diameter && o.load) throw InputError("both a diameter and a load are given; give one size");
    if (o.diameter) require_above("diameter", *o.diameter, 0, "m");
    if (o.load) require_above("load", *o.load, 0, "N");
    require_range("mouth ratio", o.mouth_ratio, 0, 0.8, "");
    require_above("buoyancy", o.buoyancy, 0, "N/m3");
    require_range("cloth weight", o.weight, 0, 1000, "N/m2");
    require_range("number of tapes", o.tapes, 3, 1000, "");
    require_range("tape weight", o.tape_weight, 0, 1000, "N/m");
    require_angle("bulge half-angle", o.bulge, 90);
}

/// The meridian scaled to metres and newtons.
Meridian scaled(Meridian meridian, const NaturalShapeOptions& options, double unit) {
    const double b = options.buoyancy;
    meridian.equation.buoyancy = b;
    meridian.equation.weight = options.weight;
    meridian.equation.tape_weight = options.tape_weight;
    for (MeridianPoint& p : meridian.stations) {
        p.s *= unit;
        p.r *= unit;
        p.z *= unit;
        p.tension *= b * unit * unit * unit;
        p.area *= unit * unit;
        p.volume *= unit * unit * unit;
    }
    return meridian;
}

}  // namespace

NaturalShape natural_shape(const NaturalShapeOptions& options) {
    require_valid(options);
    const double b = options.buoyancy;
    const double unit =
        options.diameter ? *options.diameter : std::cbrt(options.load ? *options.load / b : options.volume);
    const Problem problem{
        {1, options.weight / (b * unit), options.tapes, options.tape_weight / (b * unit * unit), options.bulge},
        options.mouth_ratio,
        options.diameter ? Problem::Size::diameter
        : options.load   ? Problem::Size::load
                         : Problem::Size::volume};
    Solution solution = follow(problem);
    NaturalShape shape;
    shape.summary.iterations = solution.iterations;
    shape.summary.reason = "with this mouth, size, weight and bulge, no meridian meets the axis at a right angle";
    if (!solution.converged) return shape;
    shape.meridian = scaled(std::move(solution.shot.meridian), options, unit);
    const MeridianPoint mouth = shape.meridian.stations.front();
    const MeridianPoint crown = shape.meridian.stations.back();
    const MeridianPoint equator = shape.meridian.equator();
    shape.length = crown.s;
    shape.height = crown.z;
    shape.max_radius = equator.r;
    shape.equator_z = equator.z;
    shape.mouth_radius = mouth.r;
    shape.area = crown.area;
    shape.volume = crown.volume;
    shape.theta0 = mouth.theta;
    shape.load = solution.x[0] * b * unit * unit * unit;
    shape.weight = options.weight * crown.area + options.tapes * options.tape_weight * crown.s;
    shape.mouth_tension = mouth.tension;
    shape.crown_tension = crown.tension;
    shape.crown_pressure = b * crown.z;
    shape.imbalance = (shape.load + shape.weight) / (b * crown.volume) - 1;
    shape.summary.termination = Termination::converged;
    shape.summary.reason = "the meridian meets the axis at a right angle";
    return shape;
}

}  // namespace ripstop
