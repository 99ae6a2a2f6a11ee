/// ripstop inspect: shows the contents of a file before tiles are made of it.
#include <fmt/format.h>

#include <filesystem>

#include "commands/commands.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/options.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/report/words/inspect_report.h"

namespace ripstop::cli {

void add_inspect(CLI::App& app) {
    struct InspectArguments {
        std::filesystem::path file;
        std::string chord, edge, tiles_are = "faces";
        bool json = false;
    };
    auto given = std::make_shared<InspectArguments>();
    CLI::App* command =
        app.add_subcommand("inspect", "Show what a file contains: unit, layers, surfaces, curves, unread objects");
    command->add_option("INPUT", given->file, "The file, in any format that is read")->type_name("FILE")->required();
    add_meshing_options(*command, given->chord, given->edge, given->tiles_are);
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the text");
    command->footer(
        "Lengths are the file's own numbers.\n\n"
        "Examples:\n"
        "  ripstop inspect envelope.obj\n"
        "  ripstop inspect envelope.obj --json          for a script\n\n"
        "Exit codes: 0 read, 2 usage, 3 unusable input.");
    command->callback([given] {
        const CadModel model = [&] {
            Waiting waiting("Reading " + given->file.filename().string(), false);
            MeshingOptions meshing = meshing_of(given->chord, given->edge, given->tiles_are);
            meshing.progress = waiting.progress();
            return read_model(given->file, meshing);
        }();
        const std::string file = given->file.filename().string();
        print("{}", given->json ? inspect_json(model, file) : inspect_text(model, file));
    });
}

}  // namespace ripstop::cli
