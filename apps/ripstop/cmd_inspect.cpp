/// ripstop inspect: what a file holds, before any tile is made of it.
#include <fmt/format.h>

#include <filesystem>

#include "commands.h"
#include "options.h"
#include "ripstop/io/mesh_file.h"
#include "ripstop/report/inspect_report.h"

namespace ripstop::cli {

void add_inspect(CLI::App& app) {
    struct Arguments {
        std::filesystem::path file;
        std::string chord, edge, tiles_are = "faces";
        bool json = false;
    };
    auto given = std::make_shared<Arguments>();
    CLI::App* command =
        app.add_subcommand("inspect", "Say what a file holds: unit, layers, surfaces, curves, the rest");
    command->add_option("INPUT", given->file, "The file, in any format that is read")->required();
    add_meshing_options(*command, given->chord, given->edge, given->tiles_are);
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the text");
    command->footer(
        "Lengths are the file's own numbers.\n"
        "Exit codes: 0 read, 3 unusable input.\n"
        "Example: ripstop inspect envelope.3dm");
    command->callback([given] {
        const CadModel model = read_model(given->file, meshing_of(given->chord, given->edge, given->tiles_are));
        const std::string file = given->file.filename().string();
        fmt::print("{}", given->json ? inspect_json(model, file) : inspect_text(model, file));
    });
}

}  // namespace ripstop::cli
