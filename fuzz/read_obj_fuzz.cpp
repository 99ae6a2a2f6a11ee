#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/obj.h"

using namespace ripstop;

/// Any bytes are either surfaces whose indices hold and whose coordinates are finite, or an InputError; and what was read
/// is read again, exactly, from what is written of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const std::vector<NamedMesh> surfaces = read_obj(in, "fuzz.obj").surfaces;
        std::stringstream written;
        for (const auto& [name, mesh, drawn, warp, attributes] : surfaces)
            if (name.empty() || mesh.triangle_count() == 0 || mesh.triangles.minCoeff() < 0 ||
                mesh.triangles.maxCoeff() >= mesh.vertex_count() || !mesh.positions.allFinite() ||
                (drawn && (drawn->rows() != mesh.vertex_count() || !drawn->allFinite())))
                std::abort();
        write_obj(written, surfaces);
        const std::vector<NamedMesh> again = read_obj(written, "written.obj").surfaces;
        if (again.size() != surfaces.size()) std::abort();
        for (std::size_t i = 0; i < again.size(); ++i)
            if (again[i].name != surfaces[i].name || again[i].mesh.positions != surfaces[i].mesh.positions ||
                again[i].mesh.triangles != surfaces[i].mesh.triangles || again[i].drawn != surfaces[i].drawn)
                std::abort();
    } catch (const InputError&) {
        return 0;
    }
    return 0;
}
