#pragma once

#include <CLI/CLI.hpp>

#include "ripstop/io/piece_format.h"

namespace ripstop::cli {

/// `flag` is what the dialect's option is called: --dialect or --dxf-dialect.
void add_dxf_options(CLI::App& command, PieceFileOptions& given, const char* flag);

/// With the date of SOURCE_DATE_EPOCH where none was given and that is set. Throws InputError for a dialect that is not known
/// and for a date that is none.
PieceFileOptions dxf_options(PieceFileOptions given);

}  // namespace ripstop::cli
