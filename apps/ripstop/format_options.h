#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// Which cut files are written, and how; lengths with their units, empty: the default.
struct FormatArguments {
    std::vector<std::string> formats;
    PieceFileOptions files = {};
    std::string frame = {};
};

/// `--format --paper --frame` and those of DXF, with `dialect` for what its dialect is called by.
void add_format_options(CLI::App& command, FormatArguments& given, const char* dialect);

/// Throws InputError for formats, papers and dialects that are not known and for a frame that is no length.
PieceFileOptions file_options(const FormatArguments& given);

}  // namespace ripstop::cli
