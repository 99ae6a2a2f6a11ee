/// ripstop diff: shows the differences between two cut plans.
#include <fmt/format.h>

#include "commands/commands.h"
#include "help/tell.h"
#include "ripstop/base/text/units.h"
#include "ripstop/pattern/revision/compare_pieces.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/report/words/revision_report.h"

namespace ripstop::cli {

void add_diff(CLI::App& app) {
    struct DiffArguments {
        std::filesystem::path before, after;
        std::string tolerance = "0.01mm";
        bool json = false;
    };
    auto given = std::make_shared<DiffArguments>();
    CLI::App* command = app.add_subcommand("diff", "Show what changed between two cut plans, piece by piece");
    command->add_option("BEFORE", given->before, "A folder that `ripstop flatten` wrote")->type_name("DIR")->required();
    command->add_option("AFTER", given->after, "The folder of a later revision")->type_name("DIR")->required();
    command->add_option("--tolerance", given->tolerance, "Lengths that differ by at most this count as equal")
        ->capture_default_str()
        ->type_name("LENGTH");
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the table");
    command->footer(
        "Pieces are matched by their names, edges by where they lie.\n\n"
        "Examples:\n"
        "  ripstop diff plan-1 plan-2\n"
        "  ripstop diff plan-1 plan-2 --tolerance 0.5mm\n\n"
        "Exit codes: 0 the same, 1 different, 2 usage, 3 unusable input.");
    command->callback([given] {
        const double tolerance = parse_length(given->tolerance, "--tolerance");
        const PieceSet before = read_pieces_of(given->before), after = read_pieces_of(given->after);
        const std::vector<PieceChange> changes = compare_pieces(before, after, tolerance);
        const std::vector<SeamTypeChange> types = compare_seam_types(before, after, tolerance);
        if (given->json)
            print("{}", revision_json(changes, types, given->before.string(), given->after.string()));
        else
            show(revision_text(changes, types));
        if (!changes.empty() || !types.empty()) throw CLI::RuntimeError(1);
    });
}

}  // namespace ripstop::cli
