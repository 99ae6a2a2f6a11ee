/// ripstop methods: lists the flattening methods, one per line.
#include <fmt/format.h>

#include "commands/commands.h"
#include "help/tell.h"
#include "ripstop/flatten/method.h"

namespace ripstop::cli {

void add_methods(CLI::App& app) {
    CLI::App* command = app.add_subcommand("methods", "List the flattening methods and their sources, one per line");
    command->footer(
        "Examples:\n"
        "  ripstop methods\n"
        "  ripstop flatten envelope.obj --method paper -o by-paper\n"
        "  ripstop compare envelope.obj --tile G01P03    all of them on one tile");
    command->callback([] {
        for (const Method& method : methods()) print("{:<16} {}\n", method.name, method.origin);
        print("{:<16} {}\n", "given", "no flattening: judges the flat positions (vt) that came with the input");
    });
}

}  // namespace ripstop::cli
