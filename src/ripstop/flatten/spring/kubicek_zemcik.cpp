#include "ripstop/flatten/spring/kubicek_zemcik.h"

#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/map/tutte.h"
#include "ripstop/flatten/tools/grain.h"
#include "ripstop/flatten/weave/woven_mesh.h"
#include "ripstop/mesh/change/flips.h"

namespace ripstop {

namespace {

std::string elasticity_note(const SpringNetwork& network, const Tile& tile) {
    const Eigen::Matrix3d C = implied_elasticity(network, tile) / 1000;
    return "the springs are equivalent to c11 = " + format_fixed(C(0, 0), 2) + ", c22 = " + format_fixed(C(1, 1), 2) +
           ", c12 = c33 = " + format_fixed(C(2, 2), 2) + " kN/m";
}

}  // namespace

Flattening flatten_kubicek_zemcik(const Tile& tile, const Fabric& fabric, const SpringMassOptions& options) {
    const SpringNetwork network = make_spring_network(tile, fabric);
    const Flattening woven = flatten_woven(tile, fabric);
    SpringMassRun run = relax_spring_mass(network, woven.positions, options);
    if (!run.summary.usable() || count_flipped(tile.mesh.triangles, run.positions) > 0) {
        const int spent = run.summary.iterations;
        run = relax_spring_mass(network, flatten_tutte(tile).positions, options);
        run.summary.iterations += spent;
        run.summary.reason += ", from Tutte's embedding, because the woven start left flipped triangles";
    }
    Flattening result{std::move(run.positions), run.summary};
    result.note = elasticity_note(network, tile);
    align_with_grain(tile, result.positions);
    return result;
}

}  // namespace ripstop
