/// ripstop diff: what changed between two cut plans.
#include <fmt/format.h>

#include "commands.h"
#include "ripstop/base/units.h"
#include "ripstop/pattern/compare_pieces.h"
#include "ripstop/report/cut_files.h"
#include "ripstop/report/revision_report.h"

namespace ripstop::cli {

void add_diff(CLI::App& app) {
    struct Arguments {
        std::filesystem::path before, after;
        std::string tolerance = "0.01mm";
        bool json = false;
    };
    auto given = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("diff", "Say what changed between two cut plans, piece by piece");
    command->add_option("before", given->before, "A folder that `ripstop flatten` wrote")->required();
    command->add_option("after", given->after, "Another")->required();
    command->add_option("--tolerance", given->tolerance, "Lengths that differ by no more are the same; 0.01mm");
    command->add_flag("--json", given->json, "Print one JSON object on stdout instead of the table");
    command->footer(
        "Pieces are matched by their names, edges by their order.\n"
        "Exit codes: 0 the same, 1 different, 2 usage, 3 unusable input.\n"
        "Example: ripstop diff plan-1 plan-2");
    command->callback([given] {
        const double tolerance = parse_length(given->tolerance, "--tolerance");
        const PieceSet before = read_pieces_of(given->before), after = read_pieces_of(given->after);
        const std::vector<PieceChange> changes = compare_pieces(before, after, tolerance);
        fmt::print("{}", given->json ? revision_json(changes, given->before.string(), given->after.string())
                                     : revision_text(changes));
        if (!changes.empty()) throw CLI::RuntimeError(1);
    });
}

}  // namespace ripstop::cli
