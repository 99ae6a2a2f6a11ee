/// Judges the flat positions of another program, the texture coordinates of an OBJ in metres: can these pieces be sewn?
#include <cstdio>

#include "ripstop/base/error.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/measure/measure_bounds.h"
#include "ripstop/tile/make_tile.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: judge_flat_positions FILE.obj\n", stderr), 2;
    const Fabric nylon = fabric_named("nylon");
    int judged = 0, refused = 0;
    for (const NamedMesh& surface : read_model(arguments[1]).surfaces) {
        if (!surface.drawn) {
            std::printf("%s has no flat positions\n", surface.name.c_str());
            continue;
        }
        const Tile tile = make_tile(surface.name, surface.mesh);
        Flattening flat;
        flat.positions = *surface.drawn;
        flat.summary = {Termination::converged, 0, 0, "given"};
        const Accuracy accuracy = measure_accuracy(tile, flat.positions, nylon);
        const Verdict verdict = judge(tile, measure_bounds(tile), flat, accuracy, tolerances_of(nylon));
        std::printf("%s: %s\n", tile.name.c_str(), verdict.manufacturable() ? "can be made" : "cannot be made");
        for (const Finding& finding : verdict.findings)
            std::printf("  %-12s %s\n", finding.code.c_str(), finding.message.c_str());
        ++judged;
        refused += verdict.manufacturable() ? 0 : 1;
    }
    std::printf("%d judged, %d cannot be made\n", judged, refused);
    return judged > 0 ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
