#pragma once

#include <string>

#include "ripstop/base/progress.h"
#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The method, the cloth and the tolerances that `flatten_envelope` uses.
struct FlattenOptions {
    std::string method = "seam-exact";  ///< a name of `methods()`, or `given`: judge what came with the tiles
    Fabric fabric = {};                 ///< of the tiles without one of their own
    Tolerances tolerances = {};
    int threads = 0;  ///< 0: one a core
    Progress progress = {};
};

/// The main job: flattens every tile by one method and judges it, then walks the seams and judges them. Tiles are
/// worked on in parallel, on their own or, where the method asks for it, together with their neighbours; the result
/// does not depend on the number of threads. Of equal tiles (`find_equal_tiles`) whose meshes correspond and that are
/// flattened on their own the first is flattened and the others take its flattening. A tile is flattened, measured and
/// judged in its own fabric. Throws InputError for an unknown method, or for `given` where a tile came without flat
/// positions.
CutPlan flatten_envelope(const Envelope& envelope, const FlattenOptions& options);

}  // namespace ripstop
