/// Reads a Rhino file: what is in it, and how its panels are understood as tiles of an envelope.
#include <cstdio>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/mesh/triangle_mesh.h"
#include "ripstop/pipeline/read/read_envelope.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: read_3dm FILE.3dm\n", stderr), 2;
    const CadModel model = read_model(arguments[1]);  // in the file's own numbers
    for (const NamedMesh& surface : model.surfaces)
        std::printf("surface %s: %d triangles\n", surface.name.c_str(), surface.mesh.triangle_count());
    for (const NamedCurve& curve : model.curves)
        std::printf("curve on layer %s: %d points\n", curve.attributes.at("layer").c_str(),
                    static_cast<int>(curve.points.rows()));
    for (const UnreadObject& object : model.unread)
        std::printf("left out: %s %s, %s\n", object.type.c_str(), object.name.c_str(), object.reason.c_str());

    const EnvelopeInput input = read_input(arguments[1], {});  // in metres, with corners, warp and seams
    std::printf("unit %s, %d seams\n", input.unit.unit.name.c_str(), static_cast<int>(input.envelope.seams.size()));
    for (const Tile& tile : input.envelope.tiles)
        std::printf("tile %s: %.3f m2, %d edges, warp from %s\n", tile.name.c_str(), surface_area(tile.mesh),
                    static_cast<int>(tile.chains.size()), tile.grain.source.c_str());
    for (const std::string& remark : input.remarks) std::printf("note: %s\n", remark.c_str());
    return input.envelope.tiles.size() == model.surfaces.size() ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}
