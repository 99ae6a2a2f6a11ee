#pragma once

#include "ripstop/energy/deformation.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// Energy, gradient and Hessian for the flat corners of a triangle: unknowns (ax, ay, bx, by, cx, cy).
struct MembraneElement {
    double energy = 0;                                                           ///< [J]
    Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();  ///< [N]
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();   ///< [N/m]
};

/// Which second derivative an element returns.
enum class Curvature {
    exact,         ///< the exact Hessian: may be indefinite except at rest
    semidefinite,  ///< the Hessian without negative curvature, so that a Newton step is a descent direction
};

/// The strain energy of the woven cloth between the flat pattern, its rest state, and the surface: orthotropic St.
/// Venant-Kirchhoff in the axes of the cloth, 1 the warp (+x) and 2 the weft (+y).
///
///     E = (C - I) / 2,  C = D⁻ᵀ G D⁻¹        D flat edges (2 x 2), G metric of the surface triangle
///     W = ½ c11 E11² + c12 E11 E22 + ½ c22 E22² + ½ g (2 E12)²      [J/m2]
///     energy = A W,  A = det D / 2                                  [J]
///
/// The unknowns are the flat corners; the surface is given. As a triangle loses its flat area, C grows like 1 / det²
/// and A W without bound, so the energy itself keeps triangles from flipping if steps stay where it is finite. It is
/// zero exactly for isometries and invariant under translations of the cloth. A rotation of the cloth changes it
/// unless the fabric is isotropic: fix the grain.
class WovenMembrane {
  public:
    /// Requires a valid fabric (`require_valid`).
    explicit WovenMembrane(const Fabric& fabric);

    /// The energy of one triangle; +infinity if det D <= 0.
    double energy(const TriangleMetric& metric, const Mat22& flat) const;

    /// The energy with its exact first and second derivatives. If det D <= 0 the energy is +infinity and the
    /// derivatives are zero. With H = dD D⁻¹ and S the second Piola-Kirchhoff stress:
    ///
    ///     d(A W)  = A (W I - C S) : H
    ///     d²(A W) = A (dE : c : dE + tr(S Hᵀ C H) + 2 (W - tr(C S)) det H),  dE = -sym(C H)
    ///
    /// so they are a 4-vector and a 4 x 4 matrix in H, mapped to the corners. `Curvature::semidefinite` clamps the
    /// eigenvalues of the 4 x 4 matrix. Takes less than a microsecond and allocates nothing.
    MembraneElement element(const TriangleMetric& metric, const Mat22& flat,
                            Curvature curvature = Curvature::exact) const;

  private:
    struct State;
    State state(const TriangleMetric& metric, const Mat22& flat, double det) const;
    Eigen::Matrix4d form_in_H(const State& s) const;

    double c11_, c12_, c22_, g_;
};

/// The energy of a flattening [J]: the sum over the triangles, +infinity if one is flipped. Positions #V x 2 [m].
double membrane_energy(const TriangleMesh& surface, const Points2& positions, const Fabric& fabric);

/// The same with `targets` (#F, edges b - a and c - a) as the triangles' target shapes.
double membrane_energy(const std::vector<Mat22>& targets, const Triangles& triangles, const Points2& positions,
                       const Fabric& fabric);

}  // namespace ripstop
