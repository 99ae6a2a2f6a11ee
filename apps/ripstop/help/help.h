#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace ripstop::cli {

/// Formats --help from the declarations: what the command does, its usage, its options by groups, its footer. The
/// width is that of the terminal, at most 100 columns; 100 elsewhere.
std::shared_ptr<CLI::FormatterBase> help_pages();

/// The message for a usage error: one sentence with a hint, `ripstop: no option "--untl"; did you mean --unit?`.
std::string usage_message(const CLI::App* app, const CLI::Error& error);

}  // namespace ripstop::cli
