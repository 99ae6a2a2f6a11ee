/// ripstop methods: the ways to flatten, a line each.
#include <fmt/format.h>

#include "commands.h"
#include "ripstop/flatten/method.h"

namespace ripstop::cli {

void add_methods(CLI::App& app) {
    CLI::App* command = app.add_subcommand("methods", "The ways to flatten, a line each, with what they come from");
    command->callback([] {
        for (const Method& method : methods()) fmt::print("{:<16} {}\n", method.name, method.origin);
        fmt::print("{:<16} {}\n", "given", "no flattening: judges the flat positions (vt) that came with the input");
    });
}

}  // namespace ripstop::cli
