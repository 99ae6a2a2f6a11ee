#pragma once

#include <CLI/CLI.hpp>

namespace ripstop::cli {

/// The exit codes of the program. Scripts rely on them, so they never change.
enum ExitCode { manufacturable = 0, not_manufacturable = 1, usage = 2, unusable_input = 3, our_fault = 4 };

void add_flatten(CLI::App& app);
void add_check(CLI::App& app);
void add_inspect(CLI::App& app);
void add_compare(CLI::App& app);
void add_methods(CLI::App& app);
void add_design(CLI::App& app);
void add_export(CLI::App& app);
void add_validate(CLI::App& app);
void add_nest(CLI::App& app);
void add_diff(CLI::App& app);
void add_inflate(CLI::App& app);
void add_lift(CLI::App& app);
void add_completion(CLI::App& app);
void add_manual(CLI::App& app);
void add_help(CLI::App& app);

}  // namespace ripstop::cli
