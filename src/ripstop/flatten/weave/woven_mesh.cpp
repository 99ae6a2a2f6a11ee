#include "ripstop/flatten/weave/woven_mesh.h"

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/weave/weave_frame.h"
#include "ripstop/flatten/weave/weave_reading.h"
#include "ripstop/flatten/weave/woven_fit.h"

namespace ripstop {

void require_valid(const WovenOptions& options) {
    const auto positive = [](double value, const char* what) {
        if (!(value > 0) || !std::isfinite(value))
            throw InputError(std::string("woven mesh: ") + what + " is " + format_fixed(value, 6) +
                             "; it must be positive and finite");
    };
    positive(options.spacing, "the spacing");
    positive(options.warp_stiffness, "the warp stiffness");
    positive(options.weft_stiffness, "the weft stiffness");
    positive(options.diagonal_stiffness, "the diagonal stiffness");
    positive(options.energy_tolerance, "the energy tolerance");
    if (options.max_iterations < 0)
        throw InputError("woven mesh: the number of iterations is negative; give 0 or more");
}

Flattening flatten_woven(const Tile& tile, const Fabric& /*fabric*/, const WovenOptions& options) {
    require_valid(options);
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const UnfoldedSurface surface(tile.mesh);
    const WeaveFrame frame = make_weave_frame(tile, adjacency, surface, options.spacing);
    const WovenFit fit =
        fit_woven_mesh(surface, frame.centre, frame.warp, frame.spacing, most_crossings(tile), options);
    return read_weave(tile, adjacency, surface, fit, frame.centre.triangle,
                      fit.at_rest ? Termination::converged : Termination::iteration_limit, weave_ending(fit));
}

}  // namespace ripstop
