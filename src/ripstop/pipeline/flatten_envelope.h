#pragma once

#include <string>

#include "ripstop/base/progress.h"
#include "ripstop/model/cut_plan.h"

namespace ripstop {

struct FlattenOptions {
    std::string method = "seam-exact";  ///< a name of `methods()`, or `given`: judge what came with the tiles
    Fabric fabric = {};
    Tolerances tolerances = {};
    int threads = 0;  ///< 0: one a core
    Progress progress = {};
};

/// The main job: flattens every tile by one method and judges it, then walks the seams and judges them. Tiles are
/// independent and worked on in parallel; the result does not depend on the number of threads. Throws InputError for an
/// unknown method, or for `given` where a tile came without flat positions.
CutPlan flatten_envelope(const Envelope& envelope, const FlattenOptions& options);

}  // namespace ripstop
