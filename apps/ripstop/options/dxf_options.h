#pragma once

#include <CLI/CLI.hpp>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// What the command line calls them, to ask whether they were given.
struct DxfFlags {
    const CLI::Option *dialect = nullptr, *grain_axis = nullptr, *date = nullptr;
};

/// `flag` is what the dialect's option is called: --dialect or --dxf-dialect. A dialect that is not known and a date that is
/// none are usage errors.
DxfFlags add_dxf_options(CLI::App& command, PieceFileOptions& given, const char* flag);

/// With the date of SOURCE_DATE_EPOCH where none was given and that is set. Throws InputError where that is none.
PieceFileOptions with_date(PieceFileOptions given);

}  // namespace ripstop::cli
