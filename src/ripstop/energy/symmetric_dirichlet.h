#pragma once

#include "ripstop/energy/woven_membrane.h"

namespace ripstop {

/// How far a triangle's map surface -> cloth is from an isometry, both ways [SS15]:
///
///     energy = A (|J|^2 + |J^-1|^2 - 4) = A ((s1 - 1/s1)^2 + (s2 - 1/s2)^2),  J = D R^-1        [m2]
///
/// R the triangle laid flat, A its area on the surface, D its edges on the cloth, s1 and s2 the singular values. Zero
/// exactly on isometries, the same for every turn of the cloth, and without bound as the flat area goes to zero: steps
/// that stay where it is finite turn nothing over. `rest` are the columns of R (`lay_flat`), `flat` those of D; det R
/// > 0. Energy [m2], gradient [m] and Hessian [1] in the unknowns of `MembraneElement`.
///
/// With c = cof J, s = |J|^2, d = det J:
///
///     dW = (1 + d^-2) 2 J - 2 s d^-3 c
///     d2W = 2 (1 + d^-2) I - 4 d^-3 (J c^T + c J^T) + 6 s d^-4 c c^T - 2 s d^-3 dc/dJ     (4 x 4)
///
/// `Curvature::semidefinite` clamps the eigenvalues of the 4 x 4 matrix. Where det D <= 0 the energy is +infinity and
/// the derivatives are zero. Under a microsecond, nothing allocated.
MembraneElement symmetric_dirichlet(const Mat22& rest, const Mat22& flat, Curvature curvature = Curvature::exact);

/// The energy alone; +infinity where det D <= 0.
double symmetric_dirichlet_energy(const Mat22& rest, const Mat22& flat);

}  // namespace ripstop
