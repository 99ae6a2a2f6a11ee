#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "commands/commands.h"
#include "ripstop/pattern/piece/pieces.h"

namespace ripstop::cli {

/// What the command line says about the pieces beyond their flat shapes; lengths with their units, empty: the default.
struct PieceArguments {
    std::string revision, corners = "mitre", notch_spacing, notch_depth, simplify;
    bool allowance_fit = false;
};

/// `--revision --corners --notch-spacing --notch-depth --simplify --allowance-fit`.
void add_piece_options(CLI::App& command, PieceArguments& given);

/// Throws InputError for lengths that are none or out of reason.
PieceOptions piece_options(const PieceArguments& given);

/// Warns of what is wrong with the cut lines of pieces that were read again, which a plan of another version may
/// have, or one that was changed. `not_manufacturable` where there is anything.
ExitCode warn_of_cut_lines(const PieceSet& set, int threads = 0);

}  // namespace ripstop::cli
