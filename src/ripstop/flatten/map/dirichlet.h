#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Stopping criteria of the symmetric Dirichlet iteration.
struct DirichletOptions {
    int max_iterations = 100;  ///< Newton steps; >= 0
    double tolerance = 1e-10;  ///< stop if no vertex moves further in a step, relative to sqrt(area); > 0
};

/// Flip-free parametrisation: minimises the symmetric Dirichlet energy [SS15] (`symmetric_dirichlet`) by Newton's
/// method, starting from Tutte's embedding. Element Hessians are clamped until full steps succeed. Every step stops
/// short of the first degenerate triangle (`longest_step`), followed by a backtracking line search. No triangle ever
/// flips, but distant parts of the boundary may overlap; the judge reports that.
///
/// Isotropic with a free boundary, exact on developable tiles. It weighs compressed and stretched triangles alike, so
/// the total area is closer than with `arap`; the outline is as wrong as the curvature makes any free one.
///
/// Requires a disk (`make_tile`). 10 to 40 factorisations of size 2 #V. Throws InputError if the options are out of
/// range.
Flattening flatten_dirichlet(const Tile& tile, const DirichletOptions& options = {});

}  // namespace ripstop
