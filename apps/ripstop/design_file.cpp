#include "design_file.h"

#include <fstream>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh_file.h"

namespace ripstop::cli {

void require_design_file(const std::filesystem::path& file, bool force) {
    if (std::filesystem::is_directory(file))
        throw InputError(file.string() + ": is a folder; name the file to write in it");
    require_written_format(file);
    if (std::filesystem::exists(file) && !force)
        throw InputError(file.string() + ": exists; give another name, or --force to replace it");
    if (const auto folder = std::filesystem::absolute(file).parent_path(); !std::filesystem::is_directory(folder))
        throw InputError(file.string() + ": cannot be written: " + folder.string() + " is no folder; make it first");
}

void write_design_file(const std::filesystem::path& file, const std::vector<NamedMesh>& tiles) {
    const std::filesystem::path partial = file.string() + ".partial";
    std::ofstream out(partial, std::ios::binary);
    write_model(out, file, tiles);
    out.close();
    std::error_code error;
    if (out) std::filesystem::rename(partial, file, error);
    if (!out || error) {
        std::filesystem::remove(partial, error);
        throw InputError(file.string() +
                         ": cannot be written; is its folder open to you, and is there room on the disk?");
    }
}

}  // namespace ripstop::cli
