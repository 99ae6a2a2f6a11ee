/// ripstop nest: lays the pieces of a cut plan on the roll.
#include <fmt/format.h>

#include "commands/commands.h"
#include "commands/known.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/format_options.h"
#include "options/piece_options.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/piece_format.h"
#include "ripstop/nest/nest_pieces.h"
#include "ripstop/plan_folder/cut_files.h"
#include "ripstop/plan_folder/marker_files.h"
#include "ripstop/plan_folder/unchanged.h"
#include "ripstop/plan_folder/update_folder.h"
#include "ripstop/plan_folder/whole_directory.h"

namespace ripstop::cli {
namespace {

struct NestArguments {
    std::filesystem::path plan, output;
    std::string roll, gap = "5mm";
    std::vector<std::string> roll_lengths, formats{"dxf", "svg", "pdf"};
    double grain_tolerance = 0;
    int effort = 40, jobs = 0;
    bool flip = false, one_way = false, force = false, json = false, quiet = false;
};

NestOptions options_of(const NestArguments& given) {
    NestOptions options;
    if (!given.roll.empty()) options.roll_width = parse_length(given.roll, "--roll");
    options.gap = parse_length(given.gap, "--gap");
    options.grain_tolerance = given.grain_tolerance * degree;
    options.may_turn = !given.one_way;
    options.may_flip = given.flip;
    for (const std::string& length : given.roll_lengths)
        options.part_lengths.push_back(parse_length(length, "--roll-length"));
    options.rounds = given.effort;
    options.threads = given.jobs;
    return options;
}

/// Refuses the folder of a cut plan, which has a bom.csv of its own.
void require_no_plan(const std::filesystem::path& folder) {
    for (const char* file : {"report.json", "pieces.json"})
        if (std::filesystem::exists(folder / file))
            throw InputError(fmt::format("{}: is part of a cut plan, it holds {}; give the marker its own folder",
                                         folder.string(), file));
}

ExitCode run(NestArguments given) {
    NestOptions options = options_of(given);
    options.progress = progress_bar(given.quiet);
    if (given.output.empty()) given.output = given.plan / "marker";
    const Unchanged read({given.plan / "cut" / "pieces.json"});
    const PieceSet set = read_pieces_of(given.plan);
    require_no_plan(given.output);
    require_writable(given.output, given.force);
    const Markers markers = nest_pieces(set, options);
    write_whole_directory(
        given.output, given.force, {"marker*.*", "bom.csv"},
        [&](const std::filesystem::path& folder) { write_marker_files(folder, set, markers, given.formats); });
    if (!show_roll(given.plan, marker_json(set, markers, given.formats), read) && !given.quiet)
        tell("Note: a different version wrote report.html, so it does not show the roll; flatten the envelope again\n");
    if (given.json)
        print("{}", marker_json(set, markers, given.formats));
    else if (!given.quiet || !markers.refusals.empty())
        show(marker_table(markers));
    const ExitCode cut_lines = warn_of_cut_lines(set, given.jobs);
    return markers.refusals.empty() ? cut_lines : not_manufacturable;
}

}  // namespace

void add_nest(CLI::App& app) {
    auto given = std::make_shared<NestArguments>();
    CLI::App* command =
        app.add_subcommand("nest", "Lay the pieces of a cut plan on the roll; write markers and bill of materials");
    command->add_option("PLAN", given->plan, "A folder that `ripstop flatten` wrote")->type_name("DIR")->required();
    command->add_option("-o,--output", given->output, "The folder to write (default PLAN/marker)")->type_name("DIR");
    command->add_option("--roll", given->roll, "Width of the cloth, such as 1500mm (default: the fabric's own)")
        ->type_name("LENGTH");
    command->add_option("--gap", given->gap, "Between pieces")->capture_default_str()->type_name("LENGTH");
    command
        ->add_option("--roll-length", given->roll_lengths,
                     "Length of a roll without a join, such as 100m; several, separated by commas, are used in order, "
                     "and the last one repeats (default: no join)")
        ->type_name("LENGTH")
        ->delimiter(',');
    command->add_option("--grain-tolerance", given->grain_tolerance, "By how much a piece may be turned off the warp")
        ->capture_default_str()
        ->type_name("DEGREES")
        ->check(within(0.0, 28.0));
    command->add_flag("--one-way", given->one_way, "Turn no piece by half a turn, for cloth with a nap or a print");
    command->add_flag("--flip", given->flip, "The cloth has no right side: pieces may be laid face down");
    command
        ->add_option("--effort", given->effort, "Rounds of the search; more is slower and the marker a little shorter")
        ->capture_default_str()
        ->type_name("N")
        ->check(within(0, 100000));
    add_format_option(*command, given->formats);
    command->add_option("-j,--jobs", given->jobs, "Threads, without effect on the result; 0: one per core")
        ->capture_default_str()
        ->type_name("N")
        ->check(within(0, 1024));
    command->add_flag("--force", given->force, "Replace the markers in the folder");
    command->add_flag("--json", given->json, "Print marker.json on stdout instead of the table");
    command->add_flag("--quiet", given->quiet, "Print nothing unless something is wrong");
    command->footer(
        "Examples:\n"
        "  ripstop nest cut-plan --roll 1500mm\n"
        "  ripstop nest cut-plan --roll 1500mm --roll-length 100m --force     with joins, replacing the last\n"
        "  ripstop nest cut-plan --one-way --effort 400 -o marker             cloth with a nap, a longer search\n\n"
        "Exit codes: 0 all laid, 1 some pieces do not fit the roll (the others are laid) or a cut line is wrong,\n"
        "2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
