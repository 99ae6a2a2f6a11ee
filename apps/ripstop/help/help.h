#pragma once

#include <CLI/CLI.hpp>
#include <memory>

namespace ripstop::cli {

/// --help from the declarations: what the command does, how it is called, its options by groups, what its footer says;
/// as wide as the terminal, 100 columns elsewhere and at most.
std::shared_ptr<CLI::FormatterBase> help_pages();

/// The usage error, as one sentence and where to read on: `ripstop: no option "--untl"; did you mean --unit?`.
std::string usage_message(const CLI::App* app, const CLI::Error& error);

}  // namespace ripstop::cli
