#include "ripstop/io/mesh_file.h"

#include <array>
#include <fstream>

#include "ripstop/base/error.h"
#include "ripstop/base/sha256.h"
#include "ripstop/io/obj.h"
#include "ripstop/io/rhino_3dm.h"
#include "ripstop/io/rhino_surfaces.h"

namespace ripstop {
namespace {

constexpr std::array<MeshFormat, 2> formats = {{
    {".obj", "Wavefront OBJ", read_obj, write_obj},
    {".3dm", "Rhino 2 to 8", read_rhino_3dm, nullptr},
}};

void require_no_folder(const std::filesystem::path& path) {
    std::error_code unknown;
    if (std::filesystem::is_directory(path, unknown))
        throw InputError(path.string() + ": is a folder, expected a file; name the file in it");
}

std::ifstream open_file(const std::filesystem::path& path) {
    require_no_folder(path);
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path.string() + ": the file cannot be opened; check its name and its permissions");
    return in;
}

}  // namespace

std::span<const MeshFormat> mesh_formats() {
    return formats;
}

CadModel read_model(const std::filesystem::path& path, const MeshingOptions& options) {
    require_no_folder(path);
    std::string extension = path.extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    std::string known;
    for (const MeshFormat& format : formats) {
        if (extension == format.extension) {
            std::ifstream in = open_file(path);
            CadModel model = format.read(in, path.string());
            if (format.read == read_rhino_3dm) add_rhino_surfaces(model, path, options);
            return model;
        }
        known += (known.empty() ? "" : ", ") + std::string(format.extension) + " (" + format.description + ")";
    }
    for (const CadFormat& format : cad_formats()) {
        if (extension == format.extension) return convert_cad(path, options);
        known += ", " + std::string(format.extension) + " (" + format.description + ")";
    }
    throw InputError(path.string() + ": no format with the extension \"" + extension + "\", expected one of: " + known +
                     "; export the surfaces in one of them");
}

std::string sha256_of_file(const std::filesystem::path& path) {
    std::ifstream in = open_file(path);
    std::string digest = sha256(in);
    if (in.bad()) throw InputError(path.string() + ": the file cannot be read to its end; check the disk it is on");
    return digest;
}

}  // namespace ripstop
