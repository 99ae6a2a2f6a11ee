#include "ripstop/io/mesh/flat_obj.h"

#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/escape.h"

namespace ripstop {

std::string flat_obj(const FlatTile& tile) {
    const TriangleMesh& mesh = tile.tile.mesh;
    std::string text =
        "# metres; vt is the place on the cloth in metres, u along the warp\no " + ascii_text(tile.tile.name) + "\n";
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        text += "v";
        for (int k = 0; k < 3; ++k) text += " " + format_shortest(mesh.positions(v, k));
        text += "\n";
    }
    for (Eigen::Index v = 0; v < tile.flattening.positions.rows(); ++v)
        text += "vt " + format_shortest(tile.flattening.positions(v, 0)) + " " +
                format_shortest(tile.flattening.positions(v, 1)) + "\n";
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        text += "f";
        for (int k = 0; k < 3; ++k) {
            const std::string index = std::to_string(mesh.triangles(t, k) + 1);
            text += " " + index + "/" + index;
        }
        text += "\n";
    }
    return text;
}

}  // namespace ripstop
