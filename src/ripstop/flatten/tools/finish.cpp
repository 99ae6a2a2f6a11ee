#include "ripstop/flatten/tools/finish.h"

#include <cmath>

#include "ripstop/flatten/tools/grain.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/change/flips.h"

namespace ripstop {

void scale_to_area(const TriangleMesh& mesh, Points2& positions) {
    double flat = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        flat += signed_area(positions.row(mesh.triangles(t, 0)), positions.row(mesh.triangles(t, 1)),
                            positions.row(mesh.triangles(t, 2)));
    if (flat > 0) positions *= std::sqrt(surface_area(mesh) / flat);
}

void finish(const Tile& tile, Flattening& flat, Termination termination, const std::string& reason) {
    if (!flat.positions.allFinite()) {
        flat.positions.setZero();
        flat.summary.termination = Termination::failed;
        flat.summary.reason = "the result has positions that are not finite";
        return;
    }
    align_with_grain(tile, flat.positions);
    flat.summary.termination = termination;
    flat.summary.reason = reason;
    if (const int flipped = count_flipped(tile.mesh.triangles, flat.positions); flipped > 0)
        flat.summary.reason +=
            ", " + std::to_string(flipped) + (flipped == 1 ? " triangle" : " triangles") + " flipped";
}

}  // namespace ripstop
