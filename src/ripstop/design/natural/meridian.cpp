#include "ripstop/design/natural/meridian.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

using std::numbers::pi;
using State = Eigen::Matrix<double, 7, 1>;

State as_state(const MeridianPoint& p) {
    return (State() << p.s, p.r, p.z, p.theta, p.tension, p.area, p.volume).finished();
}

MeridianPoint as_point(const State& y) {
    return {y[0], y[1], y[2], y[3], y[4], y[5], y[6]};
}

// Dormand and Prince 1980, RK5(4)7M: rows of the tableau; the last row is also the fifth-order solution.
constexpr std::array<std::array<double, 6>, 6> tableau{{
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
}};
constexpr std::array<double, 7> error_weights{71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                              -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

struct Step {
    State end;
    State error;
};

Step dormand_prince(const MeridianEquation& equation, const State& from, double length) {
    std::array<State, 7> slopes;
    slopes[0] = as_state(equation.slope(as_point(from)));
    Step step;
    for (std::size_t stage = 0; stage < 6; ++stage) {
        State sum = State::Zero();
        for (std::size_t k = 0; k <= stage; ++k) sum += tableau[stage][k] * slopes[k];
        step.end = from + length * sum;
        slopes[stage + 1] = as_state(equation.slope(as_point(step.end)));
    }
    step.error = State::Zero();
    for (std::size_t k = 0; k < 7; ++k) step.error += length * error_weights[k] * slopes[k];
    return step;
}

/// The scale of each entry of the state in an envelope of size `unit`.
State scales(const MeridianEquation& equation, double unit) {
    const double force = equation.buoyancy * unit * unit * unit;
    return (State() << unit, unit, unit, 1, force, unit * unit, unit * unit * unit).finished();
}

/// The first point within `length` of `from` at which `passed` becomes true.
template <class Passed>
MeridianPoint bisect(const MeridianEquation& equation, const MeridianPoint& from, double length, Passed&& passed) {
    double before = 0;
    double after = length;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (before + after);
        (passed(equation.step(from, middle)) ? after : before) = middle;
    }
    return equation.step(from, after);
}

template <class Passed>
MeridianPoint first_where(const Meridian& meridian, Passed&& passed) {
    for (std::size_t i = 1; i < meridian.stations.size(); ++i)
        if (passed(meridian.stations[i]))
            return bisect(meridian.equation, meridian.stations[i - 1],
                          meridian.stations[i].s - meridian.stations[i - 1].s, passed);
    return meridian.stations.back();
}

MeridianPoint smooth_slope(const MeridianEquation& e, const MeridianPoint& y) {
    const double sine = std::sin(y.theta);
    const double cosine = std::cos(y.theta);
    const double weight = 2 * pi * y.r * e.weight + e.tapes * e.tape_weight;
    const double turning = (-2 * pi * y.r * e.buoyancy * y.z - weight * sine) / y.tension;
    return {1, sine, cosine, turning, weight * cosine, 2 * pi * y.r, pi * y.r * y.r * cosine};
}

/// The derivative of the cloth area along the meridian: the integral of |P_s x P_u| over u on the surface of
/// `design_point`. Gauss quadrature with five points over half the gore: the integrand is smooth and even in u.
double lobed_area_slope(const MeridianEquation& e, const MeridianPoint& y, double turning) {
    constexpr std::array<double, 5> places{0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                           0.95308992296933200};
    constexpr std::array<double, 5> weights{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                            0.23931433524968324, 0.11846344252809454};
    const double sine = std::sin(y.theta);
    const double cosine = std::cos(y.theta);
    const double a = pi / e.tapes;
    const double rho_slope = sine * std::sin(a) / std::sin(e.bulge);
    const double rho = y.r * std::sin(a) / std::sin(e.bulge);
    const Eigen::Vector3d normal(cosine, 0, -sine);  // radial, around, up
    double sum = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double angle = places[i] * e.bulge;
        const double out = std::cos(angle) - std::cos(e.bulge);
        const Eigen::Vector3d up = Eigen::Vector3d(sine * std::cos(a), rho_slope * std::sin(angle), cosine) +
                                   rho_slope * out * normal + rho * out * turning * Eigen::Vector3d(-sine, 0, -cosine);
        const Eigen::Vector3d around = std::cos(angle) * Eigen::Vector3d::UnitY() - std::sin(angle) * normal;
        sum += weights[i] * up.cross(around).norm();
    }
    return 2 * e.tapes * rho * e.bulge * sum;
}

MeridianPoint lobed_slope(const MeridianEquation& e, const MeridianPoint& y) {
    const double sine = std::sin(y.theta);
    const double cosine = std::cos(y.theta);
    const double a = pi / e.tapes;
    const double B = e.bulge;
    const double section = B - std::sin(B) * std::cos(B);  // area of the section of a lobe of radius 1
    const double c = y.r * std::sin(a);
    const double rho = c / std::sin(B);
    const double d = rho * ((B + std::sin(B) * std::cos(B)) / (2 * std::sin(B)) - std::cos(B));
    const double d_c = rho * (2 * std::pow(std::sin(B), 3) / (3 * section) - std::cos(B));
    const double pull = e.tapes * 2 * e.buoyancy * (y.z - d * sine) * c;  // n 2 p c
    const double hoop = pull * std::sin(a) / std::tan(B);
    const double weight = e.tapes * (e.weight * 2 * rho * B + e.tape_weight);
    // R and Z contain th', so the equation T th' = ... is linear in it.
    const double normal = pull * (cosine * cosine * std::cos(a) + sine * sine);
    const double turning = (-normal + hoop * cosine - weight * sine) / (y.tension - normal * d);
    const double stretch = 1 - turning * d;
    const double R = pull * stretch * cosine * std::cos(a) - hoop;
    const double Z = -pull * stretch * sine;
    const double volume =
        e.tapes * (y.r * y.r * std::sin(a) * std::cos(a) * cosine + section * rho * rho * (1 - turning * d_c));
    return {1,     sine, cosine, turning, -(R * sine + Z * cosine) + weight * cosine, lobed_area_slope(e, y, turning),
            volume};
}

}  // namespace

MeridianPoint MeridianEquation::slope(const MeridianPoint& at) const {
    return bulge > 0 ? lobed_slope(*this, at) : smooth_slope(*this, at);
}

MeridianPoint MeridianEquation::step(const MeridianPoint& from, double length) const {
    return as_point(dormand_prince(*this, as_state(from), length).end);
}

MeridianPoint Meridian::at(double s) const {
    const auto above = std::upper_bound(stations.begin() + 1, stations.end() - 1, s,
                                        [](double value, const MeridianPoint& p) { return value < p.s; });
    const MeridianPoint& from = *(above - 1);
    return equation.step(from, s - from.s);
}

MeridianPoint Meridian::equator() const {
    return first_where(*this, [](const MeridianPoint& p) { return p.theta <= 0; });
}

MeridianPoint Meridian::descent_to(double r) const {
    return first_where(*this, [r](const MeridianPoint& p) { return p.theta < 0 && p.r <= r; });
}

Meridian trace_meridian(const MeridianEquation& equation, const MeridianPoint& start, double unit) {
    constexpr double tolerance = 1e-13;
    constexpr int most_steps = 100000;
    const State scale = scales(equation, unit);
    const auto past_axis = [](const MeridianPoint& p) { return p.r <= 0 && p.theta < 0; };
    Meridian meridian{equation, {start}, false};
    double length = 1e-3 * unit;
    for (int i = 0; i < most_steps; ++i) {
        const MeridianPoint from = meridian.stations.back();
        const Step step = dormand_prince(equation, as_state(from), length);
        const double error = step.error.cwiseQuotient(scale).lpNorm<Eigen::Infinity>() / tolerance;
        const double wider = std::isfinite(error) ? 0.9 * std::pow(std::max(error, 1e-10), -0.2) : 0.2;
        if (error <= 1) {
            const MeridianPoint end = as_point(step.end);
            if (past_axis(end)) {
                meridian.stations.push_back(bisect(equation, from, length, past_axis));
                meridian.on_axis = true;
                break;
            }
            meridian.stations.push_back(end);
            if (std::abs(end.theta) > pi || end.s > 30 * unit || !(end.tension > 0)) break;
        }
        length *= std::clamp(wider, 0.2, 4.0);
        if (!(length > 1e-12 * unit)) break;
    }
    return meridian;
}

}  // namespace ripstop
