#pragma once

#include <Eigen/Core>

#include "ripstop/model/flight/cloth_state.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// The response of a cloth that cannot carry compression: per area of the cloth at rest, in its axes (1 warp, 2
/// weft).
struct ClothResponse {
    ClothState state = ClothState::slack;
    double energy = 0;                                  ///< [J/m2]
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();   ///< S11, S22, S12: second Piola-Kirchhoff [N/m]
    Eigen::Vector3d tension = Eigen::Vector3d::Zero();  ///< the relaxed part of `stress`, never compressive [N/m]
    Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  ///< dS / de, positive semi-definite [N/m]
    double direction = 0;  ///< direction of the tension where wrinkled, from the warp [rad]
};

/// Tension field theory for orthotropic St. Venant-Kirchhoff cloth: the relaxed energy of a membrane that wrinkles
/// instead of carrying compression (Pipkin 1986; Steigmann 1990). With e = (E11, E22, 2 E12), S = C e and
/// psi = e·C e / 2,
///
///     psi_r(e) = min over D >= 0 of psi(e + D) = max over S >= 0 of (S·e - S·C^-1 S / 2)
///     taut:      S = C e is positive semi-definite:   psi_r = psi
///     slack:     e is negative semi-definite:         psi_r = 0
///     wrinkled:  psi_r = max over phi of <e·m>+^2 / (2 m·C^-1 m),  m = (cos^2, sin^2, sin cos) of phi
///
/// It is convex, continuously differentiable and has no parameter. `residual` adds that fraction of the unrelaxed
/// energy psi. The cloth then carries a little compression, which holds loose parts in place; its part of `tangent`
/// is the fraction times C.
class TensionField {
  public:
    /// Requires a valid fabric (`require_valid`) and residual in [0, 1].
    explicit TensionField(const Fabric& fabric, double residual = 0);

    /// The response at the Green strain (E11, E22, 2 E12). The direction of the tension is found to rounding: 25
    /// samples of the sector where the strain is positive, then a bracketed Newton iteration. Takes half a
    /// microsecond if wrinkled.
    ClothResponse at(const Eigen::Vector3d& strain) const;

  private:
    ClothResponse relaxed(const Eigen::Vector3d& strain) const;
    ClothResponse wrinkled(const Eigen::Vector3d& strain) const;

    Eigen::Matrix3d stiffness_, compliance_;
    double residual_;
};

}  // namespace ripstop
