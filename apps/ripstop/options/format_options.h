#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// The options of the cut files. Lengths are texts with units; empty: the default.
struct FormatArguments {
    std::vector<std::string> formats;  ///< the defaults, until `--format` names others
    PieceFileOptions files = {};
    std::string frame = {};

    /// An option and the formats it applies to. Without `--format`, it selects the first of them.
    struct Meant {
        const CLI::Option* option;
        std::vector<std::string> formats;
    };
    const CLI::Option* format = nullptr;
    std::vector<Meant> meant = {};
};

/// Adds `--format`, which takes several names separated by commas. An unknown format is a usage error.
CLI::Option* add_format_option(CLI::App& command, std::vector<std::string>& formats);

/// Adds `--format --paper --frame` and the options of DXF; `dialect` is the name of the option for its dialect.
void add_format_options(CLI::App& command, FormatArguments& given, const char* dialect);

/// Without `--format`, selects the formats of the given options: in addition to the defaults, or, if `alone`,
/// instead of them. An option that applies to none of the formats is a usage error (CLI::ValidationError).
void choose_formats(FormatArguments& given, bool alone);

/// Throws InputError if the frame is not a length.
PieceFileOptions file_options(const FormatArguments& given);

}  // namespace ripstop::cli
