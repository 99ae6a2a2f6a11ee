#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop::cli {

/// Throws InputError unless a design can be written to the file: the format must be known, the folder must exist, and
/// the file must not exist unless `force`.
void require_design_file(const std::filesystem::path& file, bool force);

/// Writes the tiles to a temporary file beside it, then renames that. Throws InputError on failure.
void write_design_file(const std::filesystem::path& file, const std::vector<NamedMesh>& tiles);

/// Adds `ripstop design special` to `ripstop design`.
void add_design_special(CLI::App& shapes);

}  // namespace ripstop::cli
