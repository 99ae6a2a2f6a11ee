#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/rhino/rhino_3dm.h"

using namespace ripstop;

/// Any bytes give a model or an InputError that begins with the file's name. The model's surfaces are valid
/// (indices, finite coordinates, unique names), and its curves have at least two finite points.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const CadModel model = read_rhino_3dm(in, "fuzz.3dm");
        std::set<std::string> names;
        for (const NamedMesh& surface : model.surfaces)
            if (surface.name.empty() || !names.insert(surface.name).second || surface.mesh.triangle_count() == 0 ||
                surface.mesh.triangles.minCoeff() < 0 ||
                surface.mesh.triangles.maxCoeff() >= surface.mesh.vertex_count() || !surface.mesh.positions.allFinite())
                std::abort();
        for (const NamedCurve& curve : model.curves)
            if (curve.points.rows() < 2 || !curve.points.allFinite()) std::abort();
        for (const UnreadObject& object : model.unread)
            if (object.name.empty() || object.type.empty() || object.reason.empty()) std::abort();
        if (model.unit && !(model.unit->metres > 0)) std::abort();
    } catch (const InputError& error) {
        if (std::string(error.what()).rfind("fuzz.3dm: ", 0) != 0) std::abort();
    }
    return 0;
}
