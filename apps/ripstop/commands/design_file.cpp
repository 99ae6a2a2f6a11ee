#include "commands/design_file.h"

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/text/output_file.h"

namespace ripstop::cli {

void require_design_file(const std::filesystem::path& file, bool force) {
    if (std::filesystem::is_directory(file))
        throw InputError(file.string() + ": is a folder; name the file to write in it");
    require_written_format(file);
    if (std::filesystem::exists(file) && !force)
        throw InputError(file.string() + ": exists; give another name, or --force to replace it");
    if (const auto folder = std::filesystem::absolute(file).parent_path(); !std::filesystem::is_directory(folder))
        throw InputError(file.string() + ": cannot be written: " + folder.string() + " is not a folder; make it first");
}

void write_design_file(const std::filesystem::path& file, const std::vector<NamedMesh>& tiles) {
    replace_file(file, [&](std::ostream& out) { write_model(out, file, tiles); });
}

}  // namespace ripstop::cli
