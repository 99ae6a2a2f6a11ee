#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "ripstop/model/envelope.h"

namespace ripstop {

/// A way to store surfaces in a file. Reading, the message about unknown files and the property tests all walk this table,
/// so a format is read and tested by being listed.
struct MeshFormat {
    const char* extension;  ///< with its dot, in lower case
    const char* description;
    /// Surfaces in metres; `name` begins every message, and its stem names surfaces without a name of their own.
    std::vector<NamedMesh> (*read)(std::istream& in, const std::string& name, double metres_per_unit);
    void (*write)(std::ostream& out, const std::vector<NamedMesh>& meshes);  ///< in metres; null: read only
};

std::span<const MeshFormat> mesh_formats();

/// The surfaces of a file, in the format its extension names (upper or lower case). Throws InputError where the extension is
/// none of the table's, the file cannot be read, or its format's reader refuses what is in it.
std::vector<NamedMesh> read_meshes(const std::filesystem::path& path, double metres_per_unit);

/// `sha256` of a file's bytes. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace ripstop
