/// Flattens one mesh: the first surface of a file, in metres, on nylon.
#include <cstdio>

#include "ripstop/base/error.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/tile/make_tile.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: flatten_one_mesh FILE\n", stderr), 2;
    const NamedMesh surface = read_model(arguments[1]).surfaces.front();
    const Tile tile = make_tile(surface.name, surface.mesh);
    const Fabric nylon = fabric_named("nylon");

    const Flattening flat = method_named("seam-exact").flatten(tile, nylon);
    std::printf("%s: %s\n", tile.name.c_str(), flat.summary.text().c_str());
    if (!flat.summary.usable()) return 1;

    const Accuracy accuracy = measure_accuracy(tile, flat.positions, nylon, flat.edges_on_curve);
    std::printf("%.4f m2 in space, %.4f m2 of cloth; the worst boundary edge is %.1e off its length\n", accuracy.area,
                accuracy.flat_area, accuracy.boundary_error_max);
    std::printf("first vertex: (%.3f, %.3f, %.3f) m lies at (%.3f, %.3f) m\n", tile.mesh.positions(0, 0),
                tile.mesh.positions(0, 1), tile.mesh.positions(0, 2), flat.positions(0, 0), flat.positions(0, 1));
    return accuracy.boundary_error_max < 1e-6 && accuracy.flipped == 0 ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
