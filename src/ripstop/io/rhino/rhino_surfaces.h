#pragma once

#include <filesystem>

#include "ripstop/io/cad/convert.h"

namespace ripstop {

/// Reads the surfaces that `read_rhino_3dm` left unread: Breps, surfaces, extrusions and SubDs, and all of a file
/// of Rhino 1 (`convert_rhino`). Appends them to the model's surfaces, with the names and attributes of the unread
/// entries. Surfaces that cannot be read stay unread, and a remark says why.
void add_rhino_surfaces(CadModel& model, const std::filesystem::path& file, const MeshingOptions& options);

}  // namespace ripstop
