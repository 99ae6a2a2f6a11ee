#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

namespace ripstop::cli {

/// Throws InputError unless a design can be written there: a known format, a folder that is there, and no file of that
/// name unless `force`.
void require_design_file(const std::filesystem::path& file, bool force);

/// Writes the tiles beside it, then renames. Throws InputError where that fails.
void write_design_file(const std::filesystem::path& file, const std::vector<NamedMesh>& tiles);

/// `ripstop design special`, below `ripstop design`.
void add_design_special(CLI::App& shapes);

}  // namespace ripstop::cli
