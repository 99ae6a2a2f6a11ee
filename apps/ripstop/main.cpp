/// ripstop: curved tiles in, cut patterns out.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>

#include "commands/commands.h"
#include "commands/ending.h"
#include "help/help.h"
#include "help/tell.h"
#include "ripstop/base/error.h"
#include "ripstop/numeric/symmetric_solver.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/version.h"

namespace ripstop::cli {
namespace {

std::string built_with() {
    return numeric_libraries() + (can_remesh() ? "\nmeshes made by CGAL (GPL-3): the program as built is under the GPL"
                                               : "\nbuilt without CGAL: tiles keep their meshes");
}

/// Printed output is a result, so the run fails if it cannot be written. A closed pipe is not a failure: the reader has
/// read what it wanted (`ripstop check balloon.obj | head -1`).
int arrived(int code) {
    if (std::fflush(stdout) != 0) output_error() = errno;
    if (output_error() == 0 || output_error() == EPIPE) return code;
    tell("ripstop: standard output cannot be written; is there room on the disk?\n");
    return unusable_input;
}

}  // namespace
}  // namespace ripstop::cli

int main(int argc, char** argv) {
    using namespace ripstop;
    cli::end_cleanly_on_signals();
    CLI::App app("Ripstop turns a 3D envelope divided into tiles by its seams into flat cut patterns", "ripstop");
    app.set_version_flag("--version",
                         fmt::format("ripstop {}\nsources Apache-2.0; built with {}", version, cli::built_with()),
                         "Print version, licence and libraries");
    app.formatter(cli::help_pages());
    app.set_help_flag("-h,--help", "Print this page");
    app.require_subcommand(1);
    app.failure_message(cli::usage_message);
    app.footer(
        "Examples:\n"
        "  ripstop design natural -o envelope.obj       an envelope to try things on\n"
        "  ripstop check envelope.obj                   what was read from a model, and what is wrong with it\n"
        "  ripstop flatten envelope.obj -o cut-plan     the patterns and the report\n"
        "  ripstop export cut-plan --dialect gerber     the same patterns for another cutter\n"
        "`ripstop COMMAND --help` lists the options of a command.\n\n"
        "Exit codes: 0 all manufacturable, 1 some not (all files written), 2 usage, 3 unusable input, 4 our fault.");
    cli::add_flatten(app);
    cli::add_check(app);
    cli::add_inspect(app);
    cli::add_compare(app);
    cli::add_methods(app);
    cli::add_design(app);
    cli::add_export(app);
    cli::add_validate(app);
    cli::add_nest(app);
    cli::add_diff(app);
    cli::add_inflate(app);
    cli::add_lift(app);
    cli::add_completion(app);
    cli::add_manual(app);
    cli::add_help(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::RuntimeError& result) {
        return cli::arrived(result.get_exit_code());
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? cli::manufacturable : cli::usage;
    } catch (const InputError& error) {
        cli::tell(fmt::format("ripstop: {}\n", error.what()));
        return cli::unusable_input;
    } catch (const std::exception& error) {
        cli::tell(fmt::format("ripstop: this is our fault, please report it: {}\n", error.what()));
        return cli::our_fault;
    }
    return cli::arrived(cli::manufacturable);
}
