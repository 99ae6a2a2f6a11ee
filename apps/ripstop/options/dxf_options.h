#pragma once

#include <CLI/CLI.hpp>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// The command-line options, to ask whether they were given.
struct DxfFlags {
    const CLI::Option *dialect = nullptr, *grain_axis = nullptr, *date = nullptr;
};

/// Adds the options of DXF files. `flag` is the name of the option for the dialect: --dialect or --dxf-dialect. An
/// unknown dialect and an invalid date are usage errors.
DxfFlags add_dxf_options(CLI::App& command, PieceFileOptions& given, const char* flag);

/// Fills in the date of SOURCE_DATE_EPOCH if that is set and no date was given. Throws InputError if it is
/// invalid.
PieceFileOptions with_date(PieceFileOptions given);

}  // namespace ripstop::cli
