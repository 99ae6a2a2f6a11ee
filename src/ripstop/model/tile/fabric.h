#pragma once

#include <string>

namespace ripstop {

/// A woven cloth as an orthotropic membrane in its own axes, 1 along the warp and 2 along the weft. Stiffness is
/// force per width [N/m], because the thickness of cloth is not well defined.
///
///     S = C e,  e = (E11, E22, 2 E12),  C = [c11 c12 0; c12 c22 0; 0 0 g]
///     c11 = E_warp / (1 - nu12 nu21),  c22 = E_weft / (1 - nu12 nu21),  c12 = nu12 c22 = nu21 c11
///     nu21 = nu12 E_weft / E_warp
struct Fabric {
    std::string name = "isotropic";
    std::string description;
    double warp_stiffness = 1000;  ///< E_warp [N/m]
    double weft_stiffness = 1000;  ///< E_weft [N/m]
    double shear_stiffness = 500;  ///< g [N/m]
    double poisson = 0;            ///< nu12: contraction along the weft per unit stretch along the warp
    double mass = 0.065;           ///< [kg/m2]
    double strength = 10e3;        ///< strip strength in the weaker direction, new and at 20 C [N/m]
    double roll_width = 1.5;       ///< [m]
    double strain_limit = 0.02;    ///< largest permitted warp or weft strain of a piece
    double shear_limit = 0.1745;   ///< largest permitted shear angle of a piece [rad]

    bool operator==(const Fabric&) const = default;

    double poisson_weft() const { return poisson * weft_stiffness / warp_stiffness; }
    double c11() const { return warp_stiffness / (1 - poisson * poisson_weft()); }
    double c22() const { return weft_stiffness / (1 - poisson * poisson_weft()); }
    double c12() const { return poisson * c22(); }
};

/// Throws InputError that names `place` and the value unless every stiffness, mass, width and limit is positive and
/// finite and nu12 nu21 < 1, which keeps the energy positive.
void require_valid(const Fabric& fabric, const std::string& place);

}  // namespace ripstop
