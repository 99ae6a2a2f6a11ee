#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// Which cut files are written, and how; lengths with their units, empty: the default.
struct FormatArguments {
    std::vector<std::string> formats;  ///< those written where none is asked for
    PieceFileOptions files = {};
    std::string frame = {};

    /// An option, and the formats it means something for; the first is what it asks for where `--format` is not given.
    struct Meant {
        const CLI::Option* option;
        std::vector<std::string> formats;
    };
    const CLI::Option* format = nullptr;
    std::vector<Meant> meant = {};
};

/// `--format`, several with commas; a format that is not known is a usage error.
CLI::Option* add_format_option(CLI::App& command, std::vector<std::string>& formats);

/// `--format --paper --frame` and those of DXF, with `dialect` for what its dialect is called by.
void add_format_options(CLI::App& command, FormatArguments& given, const char* dialect);

/// Without `--format`, options that belong to a format choose it: beside the usual ones, or, where `alone`, in their place.
/// An option that none of the formats heeds is a usage error (CLI::ValidationError).
void choose_formats(FormatArguments& given, bool alone);

/// Throws InputError for a frame that is no length.
PieceFileOptions file_options(const FormatArguments& given);

}  // namespace ripstop::cli
