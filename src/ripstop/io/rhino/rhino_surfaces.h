#pragma once

#include <filesystem>

#include "ripstop/io/cad/convert.h"

namespace ripstop {

/// Reads what a model of a Rhino file (`read_rhino_3dm`) left unread although it is a surface: Breps, surfaces,
/// extrusions and SubDs, and the whole of a file of Rhino 1 (`convert_rhino`). They come behind the model's surfaces,
/// by the names and with the attributes they were left out under. Where they cannot be read they stay unread, and a
/// remark says why.
void add_rhino_surfaces(CadModel& model, const std::filesystem::path& file, const MeshingOptions& options);

}  // namespace ripstop
