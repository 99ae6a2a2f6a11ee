#pragma once

#include <string>

#include "ripstop/base/progress.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The method, the cloth and the tolerances that `flatten_envelope` uses.
struct FlattenOptions {
    std::string method = "seam-exact";  ///< a name of `methods()`, or `given`: judges the tiles' own flat positions
    Fabric fabric = {};                 ///< for tiles without a fabric of their own
    Tolerances tolerances = {};
    int threads = 0;  ///< 0: one per core
    Progress progress = {};
};

/// Flattens every tile by one method and judges it, then walks the seams and judges them. Tiles are solved in parallel,
/// either alone or, if the method requires it, together with their neighbours; the result does not depend on the number
/// of threads. Of equal tiles (`find_equal_tiles`) with corresponding meshes that are solved alone, only the first is
/// flattened; the others copy its result. Each tile is flattened, measured and judged in its own fabric. Throws
/// InputError for an unknown method, or for `given` if a tile has no flat positions.
CutPlan flatten_envelope(const Envelope& envelope, const FlattenOptions& options);

}  // namespace ripstop
