#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "commands/commands.h"
#include "ripstop/pattern/piece/pieces.h"

namespace ripstop::cli {

/// The options for pieces beyond their flat shapes. Lengths are texts with units; empty: the default.
struct PieceArguments {
    std::string revision, corners = "mitre", notch_spacing, notch_depth, simplify;
    bool allowance_fit = false;
};

/// Adds `--revision --corners --notch-spacing --notch-depth --simplify --allowance-fit`.
void add_piece_options(CLI::App& command, PieceArguments& given);

/// Throws InputError for invalid or unreasonable lengths.
PieceOptions piece_options(const PieceArguments& given);

/// Warns of faults in the cut lines of pieces that were read from a plan, which may come from another version or
/// may have been edited. Returns `not_manufacturable` if there are any.
ExitCode warn_of_cut_lines(const PieceSet& set, int threads = 0);

}  // namespace ripstop::cli
