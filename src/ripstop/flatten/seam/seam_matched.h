#pragma once

#include <limits>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

struct SeamMatchedOptions {
    double slack =
        std::numeric_limits<double>::infinity();  ///< largest |stretch| of a seam, on each interval of it, > 0
    double bending = 3e-3;                        ///< stiffness of the seams about their free shape, in A^1.5 E, > 0
    int max_iterations = 40;                      ///< rounds over the envelope, > 0
    int threads = 0;                              ///< 0: one a core
    Progress progress = {};
};

/// The cut shapes of a whole envelope of least cloth energy whose seams match: the two sides of every seam are cut
/// equally long from any point of it to any other, but not as long as drawn.
///
/// With h the stretch of the seams, one for each interval and both of its sides (`SeamStretch`), and E_t(l) the least
/// energy of tile t with its edges l long, which seam-exact flattening finds (`SeamNewton`):
///
///     minimise over h   sum_t E_t(target_t + reach_t h),   |h_i| <= slack
///
/// by Newton's method, on exact derivatives: dE_t/dl = -lambda_t, the tensions of the edges, which in the end pull
/// equally hard from both sides of a seam; d2E_t/dl2 = S_t - diag(lambda / l), S_t the stiffness of the tile as its
/// edges feel it (`SeamStep::edge_stiffness`). Every round, the first too, is a set of tiles whose seams match to
/// 1e-11; rounds only lower the energy. What is in no seam keeps its length as drawn: it has no mate to agree with, and
/// mouth and crown are sewn to tapes of their own.
///
/// A seam bends about the shape it has when the tile is flattened with free edges: where the cloth hardly resists
/// shear, the longer of two neighbours pushes the other's edge, which without this would give way in waves. Edges in no
/// seam bend as in seam-exact flattening.
///
/// A tile with a fabric of its own is of that, the others of `fabric`.
///
/// Gives a flattening for each tile, in the order of the envelope: `seam_tension` is positive where the tile is pulled
/// by its neighbour, the certificate's forces are those in the cloth and across the seams, the note says how far from
/// drawn its seams are cut. A tile without a seam is flattened by `flatten_seam_exact`; so is one whose edges cannot be
/// held at what its neighbours ask, which says so and leaves them to themselves.
///
/// Deterministic on any number of threads. Some five rounds; a round costs a tile two or three factorisations of size 2
/// #V and a solve for each boundary edge, and the envelope a factorisation in the intervals. Throws InputError
/// (`find_seam_stretch`; options out of range).
std::vector<Flattening> flatten_seam_matched(const Envelope& envelope, const Fabric& fabric,
                                             const SeamMatchedOptions& options = {});

}  // namespace ripstop
