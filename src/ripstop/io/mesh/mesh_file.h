#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "ripstop/io/cad/convert.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What survives writing and reading exactly. The corners of the triangles, in their order and in double
/// precision, always do.
struct MeshKept {
    bool names = false;       ///< names, and the bounds of surfaces that are not one connected part each
    bool vertices = false;    ///< which corners share a vertex, and the order of vertices
    bool drawn = false;       ///< drawn positions, if all surfaces have them
    bool some_drawn = false;  ///< drawn positions, if only some surfaces have them
    bool warp = false;
};

/// A mesh file format. Reading, the message about unknown formats and the property tests all iterate the table of
/// formats, so a format that is listed is read and tested.
struct MeshFormat {
    const char* extension;  ///< in lower case, with its dot
    const char* description;
    /// Reads a file in its own unit. `name` begins every message; its stem names surfaces that have no name.
    CadModel (*read)(std::istream& in, const std::string& name);
    void (*write)(std::ostream& out, const std::vector<NamedMesh>& meshes);  ///< null: the format is only read
    MeshKept kept = {};                                                      ///< what `write` preserves
};

/// The table of mesh formats, which `read_model` and `write_model` use.
std::span<const MeshFormat> mesh_formats();

/// Reads a file in its own unit. The extension (upper or lower case) chooses the format: one of the table, or one
/// of `cad_formats`, whose surfaces are meshed by `options`. Throws InputError if the extension is unknown, the
/// file cannot be read, or the format's reader refuses it.
CadModel read_model(const std::filesystem::path& path, const MeshingOptions& options = {});

/// Writes meshes, in metres, in the format that the extension of `path` names. Throws InputError if that format
/// cannot be written.
void write_model(std::ostream& out, const std::filesystem::path& path, const std::vector<NamedMesh>& meshes);

/// Throws InputError if `write_model` cannot write the format of `path`.
void require_written_format(const std::filesystem::path& path);

/// The SHA-256 of a file's bytes. Throws InputError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace ripstop
