#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct ArapOptions {
    int max_iterations = 1000;  ///< iterations of one local and one global step, >= 0
    double tolerance = 1e-8;    ///< stop if no vertex moves further in an iteration, relative to √area, > 0
};

/// As-rigid-as-possible flattening [Liu, Zhang, Xu, Gotsman, Gortler 2008], rotated to the tile's grain.
///
///     minimises Σ_t A_t |J_t - L_t|²,  L_t the rotation nearest to J_t,  J_t the map surface -> cloth
///
/// which equals ½ Σ_t Σ_i cot θ_i |(u_i - u_i+1) - L_t (x_i - x_i+1)|². It alternates between all L_t (in closed
/// form) and all positions (one cotangent system, factorised once). The energy never rises. Convergence is linear,
/// and slower for finer meshes. Negative cotangents of obtuse triangles do no harm: the sum per triangle is
/// A |J - L|² all the same.
///
/// Isotropic with a free boundary: it shows how developable a tile is, and is a good start for other methods. Exact
/// on developable tiles. It does not prevent flipped triangles; the summary counts them.
///
/// Starts from `flatten_lscm` or from given positions (#V x 2). Throws InputError if the options are out of range or
/// the start has a different number of vertices.
Flattening flatten_arap(const Tile& tile, const ArapOptions& options = {});
Flattening flatten_arap(const Tile& tile, const Points2& start, const ArapOptions& options = {});

}  // namespace ripstop
