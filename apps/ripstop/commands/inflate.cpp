/// ripstop inflate: sews the pieces of a cut plan, fills them with hot air and compares the shape with the drawing.
#include <fmt/format.h>

#include "commands/commands.h"
#include "commands/known.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/flight_options.h"
#include "options/options.h"
#include "ripstop/pipeline/flight/compensate.h"
#include "ripstop/pipeline/flight/inflate_plan.h"
#include "ripstop/pipeline/flight/tape_seams.h"
#include "ripstop/pipeline/plan.h"
#include "ripstop/plan_folder/update_folder.h"
#include "ripstop/plan_folder/whole_directory.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/words/inflated_says.h"
#include "ripstop/report/words/inflated_text.h"

namespace ripstop::cli {
namespace {

struct InflateArguments {
    std::filesystem::path plan;
    std::string project;
    FlightArguments flight;
    bool whole = false, sensitivity = false, json = false, quiet = false, reproducible = false;
    int jobs = 0;
};

ExitCode run(const InflateArguments& given) {
    Plan plan = read_plan(given.plan);
    CutPlan& cut = plan.cut;
    require_writable(given.plan, true);
    const std::optional<Project> project = project_of(given.project, cut.unit);
    const Flight flight = flight_of(given.flight, project ? project->flight : cut.flight.value_or(Flight{}));
    tape_seams(cut, flight.tapes);
    InflatePlanOptions options{flight.load, flight.rigging};
    options.use_symmetry = !given.whole;
    options.threads = given.jobs;
    options.progress = progress_bar(given.quiet);
    cut.inflated = inflate_plan(cut, options);
    if (given.sensitivity) {
        options.progress = progress_bar(given.quiet);
        cut.inflated->sensitivity = measure_sensitivity(cut, options);
    }
    {
        const Waiting waiting("Writing " + given.plan.string(), given.quiet);
        WriteOptions writing;
        writing.reproducible = given.reproducible;
        writing.threads = given.jobs;
        update_plan(given.plan, plan, writing);
    }
    if (given.json)
        print("{}", report_of(given.plan));
    else if (!given.quiet)
        show(inflated_text(cut));
    return flies_as_drawn(cut) ? manufacturable : not_manufacturable;
}

}  // namespace

void add_inflate(CLI::App& app) {
    auto given = std::make_shared<InflateArguments>();
    CLI::App* command = app.add_subcommand("inflate", "Sew the pieces, inflate them, compare with the drawn shape");
    command->add_option("PLAN", given->plan, "A folder that `ripstop flatten` wrote")->type_name("DIR")->required();
    command->add_option("--project", given->project, "JSON whose key `flight` describes the flight (docs/project.md)")
        ->type_name("FILE");
    add_flight_options(*command, given->flight);
    command->add_flag("--whole", given->whole, "Compute the whole envelope even if its sectors are equal");
    command->add_flag("--sensitivity", given->sensitivity,
                      "Also inflate with stiffer and softer cloth, longer and shorter tapes, hotter and colder air");
    command->add_option("-j,--jobs", given->jobs, "Threads, without effect on the result; 0: one per core")
        ->capture_default_str()
        ->type_name("N")
        ->check(within(0, 1024));
    command->add_flag("--json", given->json, "Print the updated report.json on stdout instead of the table");
    command->add_flag("--quiet", given->quiet, "No table, no progress");
    command->add_flag("--reproducible", given->reproducible, "Leave the seconds out of report.json");
    command->footer(
        "Adds to PLAN: `inflated` in report.json, the shape in flight in report.html, inflated/envelope.obj.\n\n"
        "Examples:\n"
        "  ripstop inflate cut-plan                                    load tapes as the seam types say\n"
        "  ripstop inflate cut-plan --tapes meridians --inside 110     tapes up the envelope, hotter air\n"
        "  ripstop inflate cut-plan --tapes meridians --sensitivity    and how sensitive the result is\n\n"
        "Exit codes: 0 flies as drawn and is strong enough, 1 does not (all is written), 2 usage, 3 unusable input.");
    command->callback([given] {
        if (const ExitCode code = run(*given)) throw CLI::RuntimeError(code);
    });
}

}  // namespace ripstop::cli
