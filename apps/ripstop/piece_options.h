#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ripstop/pattern/pieces.h"

namespace ripstop::cli {

/// What the command line says about the pieces beyond their flat shapes; lengths with their units, empty: the default.
struct PieceArguments {
    std::string revision, corners = "mitre", notch_spacing, notch_depth, simplify;
};

/// `--revision --corners --notch-spacing --notch-depth --simplify`.
void add_piece_options(CLI::App& command, PieceArguments& given);

/// Throws InputError for lengths that are none or out of reason.
PieceOptions piece_options(const PieceArguments& given);

}  // namespace ripstop::cli
