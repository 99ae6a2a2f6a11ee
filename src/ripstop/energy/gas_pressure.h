#pragma once

#include "ripstop/energy/relaxed_membrane.h"

namespace ripstop {

/// The gauge pressure of the gas inside an envelope: p(z) = base + rise (z - floor) [Pa]. For hot air above an open
/// mouth, base is 0, rise is b (`buoyancy`) and floor is the mouth plane.
struct GasPressure {
    double base = 0;   ///< pressure at the floor [Pa]
    double rise = 0;   ///< b: gradient with height [N/m3]
    double floor = 0;  ///< height of the floor [m]

    double at(double z) const { return base + rise * (z - floor); }
};

/// The potential of the gas on a triangle of the skin, counter-clockwise seen from outside: its share of - integral
/// of p dV. The sum over a closed skin of flat triangles is exact, whatever its shape. By the divergence theorem for
/// the field (0, 0, P(z)) with P' = p,
///
///     energy = - A_xy (base (z1 + z2 + z3) / 3 + rise (z1^2 + z2^2 + z3^2 + z1 z2 + z2 z3 + z3 z1) / 12)
///
/// where A_xy is the signed projected area and z is measured from the floor. An opening needs no cap if it lies in
/// the floor's plane or in a vertical plane of symmetry. The gradient is exactly the follower load; the Hessian is
/// symmetric and indefinite.
SpaceElement gas_element(const GasPressure& gas, const Vec3& a, const Vec3& b, const Vec3& c);

/// The energy only.
double gas_energy(const GasPressure& gas, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace ripstop
