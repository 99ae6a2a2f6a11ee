#pragma once

#include "ripstop/energy/tension_field.h"
#include "ripstop/geometry/types.h"

namespace ripstop {

/// A vector and a matrix over the three corners of a triangle in space.
using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat99 = Eigen::Matrix<double, 9, 9>;

/// Energy, gradient and Hessian for the corners of a triangle in space: unknowns (ax, ay, az, bx, …, cz).
struct SpaceElement {
    double energy = 0;              ///< [J]
    Vec9 gradient = Vec9::Zero();   ///< [N]
    Mat99 hessian = Mat99::Zero();  ///< [N/m]
};

/// A membrane triangle from its flat cut shape to space: F = Ds D^-1 (3 x 2), E = (F^T F - I) / 2, and
/// energy = A psi_r(E) with A = det D / 2.
class RelaxedMembrane {
  public:
    /// `flat`: columns b - a and c - a on the cloth [m]. Requires det > 0.
    explicit RelaxedMembrane(const Mat22& flat);

    double area() const { return area_; }  ///< area of the cloth [m2]

    /// The deformation gradient F from the cloth's axes to space (3 x 2).
    Mat32 deformation(const Vec3& a, const Vec3& b, const Vec3& c) const;

    double energy(const TensionField& cloth, const Vec3& a, const Vec3& b, const Vec3& c) const;

    /// The energy with its exact gradient. The Hessian is exact and positive semi-definite without a residual
    /// stiffness. With one, the compressive part of the geometric stiffness is dropped so that it stays
    /// semi-definite:
    ///
    ///     H = A (B^T (dS/de) B + sum S_ij N_vi N_wj I),  S the `tension` alone
    SpaceElement element(const TensionField& cloth, const Vec3& a, const Vec3& b, const Vec3& c) const;

  private:
    Eigen::Matrix<double, 3, 2> shape_;  ///< row v: the derivative of F's columns with respect to corner v
    double area_;
};

/// The Green strain (E11, E22, 2 E12) of F.
Vec3 green_voigt(const Mat32& F);

/// The principal Cauchy tensions (force per deformed width) for a second Piola-Kirchhoff stress (S11, S22, S12):
/// eigenvalues of N = F S F^T / J in the plane of the triangle [N/m], the larger first.
Vec2 principal_tensions(const Mat32& F, const Vec3& stress);

}  // namespace ripstop
