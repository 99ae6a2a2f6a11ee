#pragma once

#include <Eigen/Core>

#include "ripstop/model/flight/cloth_state.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// What a cloth that cannot push bears at a strain: all per area of the cloth at rest, in its axes (1 warp, 2 weft).
struct ClothResponse {
    ClothState state = ClothState::slack;
    double energy = 0;                                  ///< [J/m2]
    Eigen::Vector3d stress = Eigen::Vector3d::Zero();   ///< S11, S22, S12: second Piola-Kirchhoff [N/m]
    Eigen::Vector3d tension = Eigen::Vector3d::Zero();  ///< of `stress` the relaxed part, which never pushes [N/m]
    Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  ///< dS / de, positive semi-definite [N/m]
    double direction = 0;                               ///< of the tension where wrinkled, from the warp [rad]
};

/// Orthotropic St. Venant-Kirchhoff cloth that wrinkles instead of pushing: the relaxed energy (Pipkin 1986; Steigmann
/// 1990). With e = (E11, E22, 2 E12), S = C e and psi = e·C e / 2,
///
///     psi_r(e) = min over D >= 0 of psi(e + D) = max over S >= 0 of (S·e - S·C^-1 S / 2)
///     taut:      S = C e is positive semi-definite:   psi_r = psi
///     slack:     e is negative semi-definite:         psi_r = 0
///     wrinkled:  psi_r = max over phi of <e·m>+^2 / (2 m·C^-1 m),  m = (cos^2, sin^2, sin cos) of phi
///
/// which is convex, once differentiable, and free of a parameter. `residual` adds that share of the unrelaxed energy
/// psi: cloth then pushes a little, which ties down what hangs loose; its part of `tangent` is C times the share.
class TensionField {
  public:
    /// Requires a valid fabric (`require_valid`) and residual in [0, 1].
    explicit TensionField(const Fabric& fabric, double residual = 0);

    /// At the Green strain (E11, E22, 2 E12). The angle of the tension is found to round-off: 25 samples of the sector
    /// where the strain is positive, then Newton's method in a bracket. Half a microsecond where wrinkled.
    ClothResponse at(const Eigen::Vector3d& strain) const;

  private:
    ClothResponse relaxed(const Eigen::Vector3d& strain) const;
    ClothResponse wrinkled(const Eigen::Vector3d& strain) const;

    Eigen::Matrix3d stiffness_, compliance_;
    double residual_;
};

}  // namespace ripstop
