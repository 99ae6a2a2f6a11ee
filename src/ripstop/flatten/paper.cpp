#include "ripstop/flatten/paper.h"

#include "ripstop/flatten/grain.h"
#include "ripstop/flatten/tutte.h"
#include "ripstop/flatten/woven_mesh.h"
#include "ripstop/mesh/flips.h"

namespace ripstop {

Flattening flatten_paper(const Tile& tile, const Fabric& fabric, const SpringMassOptions& options) {
    const SpringNetwork network = make_spring_network(tile, fabric);
    const Flattening woven = flatten_woven(tile, fabric);
    SpringMassRun run = relax_spring_mass(network, woven.positions, options);
    if (!run.summary.usable() || count_flipped(tile.mesh.triangles, run.positions) > 0) {
        const int spent = run.summary.iterations;
        run = relax_spring_mass(network, flatten_tutte(tile).positions, options);
        run.summary.iterations += spent;
        run.summary.reason += ", from Tutte's embedding as the woven start left triangles turned over";
    }
    Flattening result{std::move(run.positions), run.summary};
    align_with_grain(tile, result.positions);
    return result;
}

}  // namespace ripstop
