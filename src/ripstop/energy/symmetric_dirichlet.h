#pragma once

#include "ripstop/energy/woven_membrane.h"

namespace ripstop {

/// The symmetric Dirichlet energy of a triangle's map surface -> cloth, which measures its distance from an isometry
/// in both directions [SS15]:
///
///     energy = A (|J|^2 + |J^-1|^2 - 4) = A ((s1 - 1/s1)^2 + (s2 - 1/s2)^2),  J = D R^-1        [m2]
///
/// R is the triangle laid flat, A its area on the surface, D its edges on the cloth; s1 and s2 are the singular
/// values of J. The energy is zero exactly for isometries, invariant under rotations of the cloth, and unbounded as
/// the flat area goes to zero, so steps that keep it finite flip nothing. `rest` holds the columns of R (`lay_flat`),
/// `flat` those of D. Requires det R > 0. Energy [m2], gradient [m] and Hessian [1] in the unknowns of
/// `MembraneElement`.
///
/// With c = cof J, s = |J|^2, d = det J:
///
///     dW = (1 + d^-2) 2 J - 2 s d^-3 c
///     d2W = 2 (1 + d^-2) I - 4 d^-3 (J c^T + c J^T) + 6 s d^-4 c c^T - 2 s d^-3 dc/dJ     (4 x 4)
///
/// `Curvature::semidefinite` clamps the eigenvalues of the 4 x 4 matrix. If det D <= 0 the energy is +infinity and
/// the derivatives are zero. Takes less than a microsecond and allocates nothing.
MembraneElement symmetric_dirichlet(const Mat22& rest, const Mat22& flat, Curvature curvature = Curvature::exact);

/// The energy only; +infinity if det D <= 0.
double symmetric_dirichlet_energy(const Mat22& rest, const Mat22& flat);

}  // namespace ripstop
