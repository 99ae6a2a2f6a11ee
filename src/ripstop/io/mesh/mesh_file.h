#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "ripstop/io/cad/convert.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What of surfaces comes back exactly as it was from what is written of them; their triangles' corners, in order and
/// in double precision, always do.
struct MeshKept {
    bool names = false;       ///< and the bounds of surfaces that are not one connected part each
    bool vertices = false;    ///< which corners are one vertex, and the order of vertices
    bool drawn = false;       ///< where all surfaces have drawn positions
    bool some_drawn = false;  ///< where only some have
    bool warp = false;
};

/// A way to store surfaces in a file. Reading, the message about unknown files and the property tests all walk this
/// table, so a format is read and tested by being listed.
struct MeshFormat {
    const char* extension;  ///< with its dot, in lower case
    const char* description;
    /// In the file's own numbers; `name` begins every message, and its stem names surfaces without a name of their own.
    CadModel (*read)(std::istream& in, const std::string& name);
    void (*write)(std::ostream& out, const std::vector<NamedMesh>& meshes);  ///< null: read only
    MeshKept kept = {};                                                      ///< by `write`
};

/// The table of mesh formats, which `read_model` and `write_model` walk.
std::span<const MeshFormat> mesh_formats();

/// What a file holds, in its own numbers, by the format its extension names (upper or lower case): one of the table, or
/// one of `cad_formats`, whose surfaces are meshed as `options` say. Throws InputError where the extension is none of
/// these, the file cannot be read, or its format's reader refuses what is in it.
CadModel read_model(const std::filesystem::path& path, const MeshingOptions& options = {});

/// Writes meshes, in metres, in the format the extension of `path` names. Throws InputError where that is none that is
/// written.
void write_model(std::ostream& out, const std::filesystem::path& path, const std::vector<NamedMesh>& meshes);

/// Throws InputError as `write_model` does.
void require_written_format(const std::filesystem::path& path);

/// `sha256` of a file's bytes. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace ripstop
