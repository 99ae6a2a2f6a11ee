#include "ripstop/io/mesh/mesh_file.h"

#include <array>

#include "ripstop/base/error.h"
#include "ripstop/base/sha256.h"
#include "ripstop/base/text/lower_case.h"
#include "ripstop/io/mesh/obj.h"
#include "ripstop/io/mesh/off.h"
#include "ripstop/io/mesh/ply.h"
#include "ripstop/io/mesh/stl.h"
#include "ripstop/io/rhino/rhino_3dm.h"
#include "ripstop/io/rhino/rhino_surfaces.h"
#include "ripstop/io/text/input_file.h"

namespace ripstop {
namespace {

constexpr std::array<MeshFormat, 5> mesh_format_table = {{
    {".obj",
     "Wavefront OBJ",
     read_obj,
     write_obj,
     {.names = true, .vertices = true, .drawn = true, .some_drawn = true}},
    {".ply", "Stanford PLY", read_ply, write_ply, {.names = true, .vertices = true, .drawn = true, .warp = true}},
    {".stl", "STL", read_stl, write_stl, {.names = true}},
    {".off", "Geomview OFF", read_off, write_off, {.vertices = true, .drawn = true}},
    {".3dm", "Rhino 2 to 8", read_rhino_3dm, nullptr},
}};

/// Formats that people use and that we do not read.
constexpr std::array<std::array<const char*, 2>, 14> other_formats = {{
    {".3ds", "3D Studio"},
    {".blend", "Blender"},
    {".catpart", "CATIA"},
    {".dae", "COLLADA"},
    {".dwg", "AutoCAD"},
    {".dxf", "AutoCAD DXF"},
    {".f3d", "Fusion"},
    {".fbx", "Autodesk FBX"},
    {".glb", "binary glTF"},
    {".gltf", "glTF"},
    {".ipt", "Inventor"},
    {".max", "3ds Max"},
    {".skp", "SketchUp"},
    {".sldprt", "SolidWorks"},
}};

/// The extension of a path, in lower case.
std::string extension_of(const std::filesystem::path& path) {
    return lower_case(path.extension().string());
}

enum class Use { read, write };

/// The format that the extension of a path names, among those that support this use.
const MeshFormat& format_of(const std::filesystem::path& path, Use use) {
    const std::string extension = extension_of(path);
    std::string known;
    const auto add = [&known](const auto& format) {
        known += (known.empty() ? "" : ", ") + std::string(format.extension) + " (" + format.description + ")";
    };
    for (const MeshFormat& format : mesh_format_table) {
        if (use == Use::write && format.write == nullptr) continue;
        if (extension == format.extension) return format;
        add(format);
    }
    if (use == Use::write)
        throw InputError(path.string() + ": no format that can be written has the extension \"" + extension +
                         "\", expected one of: " + known + "; change the extension");
    for (const CadFormat& format : cad_formats()) add(format);
    std::string what = "no format with the extension \"" + extension + "\"";
    for (const auto& [other, program] : other_formats)
        if (extension == other) what = "a file of " + std::string(program) + ", which is not read";
    throw InputError(path.string() + ": " + what + ", expected one of: " + known +
                     "; export the surfaces in one of them");
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
    return mesh_format_table;
}

CadModel read_model(const std::filesystem::path& path, const MeshingOptions& options) {
    require_plain_file(path);
    const std::string extension = extension_of(path);
    for (const CadFormat& format : cad_formats())
        if (extension == format.extension) return convert_cad(path, options);
    const MeshFormat& format = format_of(path, Use::read);
    std::ifstream in = open_input(path);
    CadModel model = format.read(in, path.string());
    if (format.read == read_rhino_3dm) add_rhino_surfaces(model, path, options);
    return model;
}

void require_written_format(const std::filesystem::path& path) {
    format_of(path, Use::write);
}

void write_model(std::ostream& out, const std::filesystem::path& path, const std::vector<NamedMesh>& meshes) {
    format_of(path, Use::write).write(out, meshes);
}

std::string sha256_of_file(const std::filesystem::path& path) {
    std::ifstream in = open_input(path);
    std::string digest = sha256(in);
    if (in.bad()) throw InputError(path.string() + ": the file cannot be read to its end; check the disk it is on");
    return digest;
}

}  // namespace ripstop
