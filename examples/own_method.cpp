/// Puts a flattening method of one's own beside those of the library: the view of the tile along its mean normal.
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <vector>

#include "ripstop/base/error.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/measure/measure_bounds.h"
#include "ripstop/tile/make_tile.h"

namespace {

/// +x along the warp, +y along the weft, the outside of the cloth up.
ripstop::Flattening view(const ripstop::Tile& tile, const ripstop::Fabric&) {
    const ripstop::Vec3 up = area_vector(tile.mesh).normalized();
    const ripstop::Vec3 warp = (tile.grain.direction - up * up.dot(tile.grain.direction)).normalized();
    ripstop::Flattening flat;
    flat.positions.resize(tile.mesh.vertex_count(), 2);
    flat.positions << tile.mesh.positions * warp, tile.mesh.positions * up.cross(warp);
    flat.summary = {ripstop::Termination::converged, 1, 0, "projected"};
    return flat;
}

}  // namespace

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: own_method FILE\n", stderr), 2;
    const NamedMesh surface = read_model(arguments[1]).surfaces.front();
    const Tile tile = make_tile(surface.name, surface.mesh);
    const Fabric cloth;

    std::vector<Method> table(methods().begin(), methods().end());
    table.push_back({"view", "this program", view});
    double error_of_view = 0, least_error = 1;
    for (const Method& method : table) {
        const Flattening flat = method.flatten(tile, cloth);
        if (!flat.summary.usable()) continue;
        const Accuracy accuracy = measure_accuracy(tile, flat.positions, cloth, flat.edges_on_curve);
        const Verdict verdict = judge(tile, measure_bounds(tile), flat, accuracy, tolerances_of(cloth));
        std::printf("%-16s area %+8.4f %%  worst edge %8.4f %%  %s\n", method.name, 100 * accuracy.area_error,
                    100 * accuracy.boundary_error_max, verdict.manufacturable() ? "can be made" : "cannot be made");
        error_of_view = accuracy.boundary_error_max;
        least_error = std::min(least_error, accuracy.boundary_error_max);
    }
    return error_of_view > least_error ? 0 : 1;  // the view is the last, and none of the best
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
