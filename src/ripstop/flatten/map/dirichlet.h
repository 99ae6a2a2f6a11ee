#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// When the symmetric Dirichlet iteration stops.
struct DirichletOptions {
    int max_iterations = 100;  ///< Newton steps; >= 0
    double tolerance = 1e-10;  ///< stop where a step moves no vertex by more than this share of sqrt(area); > 0
};

/// Flip-free parametrisation: minimises the symmetric Dirichlet energy [SS15] (`symmetric_dirichlet`) from Tutte's
/// embedding by Newton's method, element Hessians clamped until whole steps are taken, every step stopped short of the
/// first triangle without area (`longest_step`), then halved until the energy falls enough. No triangle is ever turned
/// over; which overlaps remain possible between distant parts of the boundary is for the judge to find.
///
/// Isotropic, boundary free, exact on developable tiles. It weighs a triangle pressed together and one pulled out
/// alike, so the whole area is nearer than with `arap`, and the outline is as wrong as the curvature makes any free
/// one.
///
/// Requires a disk (`make_tile`). 10 to 40 factorisations of size 2 #V. Throws InputError for options out of range.
Flattening flatten_dirichlet(const Tile& tile, const DirichletOptions& options = {});

}  // namespace ripstop
