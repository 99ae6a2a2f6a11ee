#pragma once

#include <limits>
#include <vector>

#include "ripstop/base/progress.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

struct SeamMatchedOptions {
    double slack = std::numeric_limits<double>::infinity();  ///< largest |stretch| of any interval of a seam, > 0
    double bending = 3e-3;    ///< bending stiffness of the seams about their free shape, in A^1.5 E, > 0
    int max_iterations = 40;  ///< iterations over the envelope, > 0
    int threads = 0;          ///< 0: one per core
    Progress progress = {};
};

/// The cut shapes of a whole envelope that minimise the cloth energy with matching seams: both sides of every seam
/// have equal lengths between any two of its points, but not necessarily the drawn length.
///
/// Let h be the stretch of the seams, one value per interval for both of its sides (`SeamStretch`). Let E_t(l) be the
/// least energy of tile t with edge lengths l, as found by seam-exact flattening (`SeamNewton`). The method
///
///     minimises over h   sum_t E_t(target_t + reach_t h),   |h_i| <= slack
///
/// by Newton's method with exact derivatives. dE_t/dl = -lambda_t are the edge tensions; in the end they are equal on
/// both sides of a seam. d2E_t/dl2 = S_t - diag(lambda / l), where S_t is the stiffness of the tile condensed to its
/// edges (`SeamStep::edge_stiffness`). After every iteration, the first included, the seams match to 1e-11, and
/// iterations only lower the energy. Edges in no seam keep their drawn length: they have no mate to agree with, and
/// mouth and crown are sewn to tapes of their own.
///
/// A seam bends about its shape in the tile flattened with free edges. Where cloth hardly resists shear, the longer
/// of two neighbours compresses the other's edge, which would buckle in waves without this. Edges in no seam bend as
/// in seam-exact flattening.
///
/// A tile with a fabric of its own uses that, the others use `fabric`.
///
/// Returns one flattening per tile, in the order of the envelope. `seam_tension` is positive where the neighbour
/// pulls. The forces of the certificate are those in the cloth and across the seams. The note says by how much the
/// seams differ from their drawn length. A tile without a seam is flattened by `flatten_seam_exact`. So is a tile
/// whose edges cannot be held at the lengths its neighbours need; its note says so, and the neighbours are computed
/// without it.
///
/// Deterministic on any number of threads. About five iterations. Each costs two or three factorisations of size 2 #V
/// and a solve per boundary edge for each tile, and one factorisation in the intervals for the envelope. Throws
/// InputError (`find_seam_stretch`; options out of range).
std::vector<Flattening> flatten_seam_matched(const Envelope& envelope, const Fabric& fabric,
                                             const SeamMatchedOptions& options = {});

}  // namespace ripstop
