#pragma once

#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

struct ArapOptions {
    int max_iterations = 1000;  ///< local and global step together, >= 0
    double tolerance = 1e-8;    ///< stop when no vertex moves farther in an iteration, as a share of √area, > 0
};

/// As-rigid-as-possible flattening [Liu, Zhang, Xu, Gotsman, Gortler 2008], turned to the tile's grain.
///
///     minimises Σ_t A_t |J_t - L_t|²,  L_t the rotation nearest to J_t,  J_t the map surface -> cloth
///
/// the same as ½ Σ_t Σ_i cot θ_i |(u_i - u_i+1) - L_t (x_i - x_i+1)|². In turn every L_t (a closed form) and all
/// positions (one cotangent system, factorised once). The energy never rises; convergence is linear, slower the finer
/// the mesh. Obtuse triangles have negative cotangents, which does no harm: each triangle's sum is A |J - L|² all the
/// same.
///
/// Isotropic and with a free boundary: the best single picture of how developable a tile is, and a good start. Exact on
/// developable tiles. It does not keep triangles from turning over; their number is in the summary.
///
/// Starts from `flatten_lscm`, or from given positions (#V x 2). Throws InputError if the options are out of range or
/// the start has another number of vertices.
Flattening flatten_arap(const Tile& tile, const ArapOptions& options = {});
Flattening flatten_arap(const Tile& tile, const Points2& start, const ArapOptions& options = {});

}  // namespace ripstop
