#pragma once

#include "ripstop/energy/relaxed_membrane.h"

namespace ripstop {

/// The gauge pressure of the gas inside an envelope: p(z) = base + rise (z - floor) [Pa]. Hot air above an open mouth:
/// base 0, rise b (`buoyancy`), floor the mouth plane.
struct GasPressure {
    double base = 0;   ///< at the floor [Pa]
    double rise = 0;   ///< b [N/m3]
    double floor = 0;  ///< [m]

    double at(double z) const { return base + rise * (z - floor); }
};

/// The potential of the gas on a triangle of the skin, outside up where counter-clockwise: the part of - integral of p
/// dV that belongs to it, so the sum over a skin is exact for flat triangles, whatever its shape. With the field (0, 0,
/// P(z)), P' = p, by the divergence theorem
///
///     energy = - A_xy (base (z1 + z2 + z3) / 3 + rise (z1^2 + z2^2 + z3^2 + z1 z2 + z2 z3 + z3 z1) / 12)
///
/// A_xy is the projected area, signed; z counts from the floor. An opening needs no cap where it lies in the floor's
/// plane or in a vertical plane of symmetry. The gradient is the follower load, exactly; the Hessian is symmetric and
/// indefinite.
SpaceElement gas_element(const GasPressure& gas, const Vec3& a, const Vec3& b, const Vec3& c);

/// The energy alone.
double gas_energy(const GasPressure& gas, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ripstop
