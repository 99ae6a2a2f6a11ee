#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// Which cut files are written, and how; lengths with their units, empty: the default.
struct FormatArguments {
    std::vector<std::string> formats;
    std::string paper = "roll", frame = {};
};

/// `--format --paper --frame`.
void add_format_options(CLI::App& command, FormatArguments& given);

/// Throws InputError for formats and papers that are not known and for a frame that is no length.
PieceFileOptions file_options(const FormatArguments& given);

}  // namespace ripstop::cli
