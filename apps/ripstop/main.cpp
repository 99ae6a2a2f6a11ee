/// ripstop: curved tiles in, cut patterns out.
#include <fmt/format.h>

#include <exception>

#include "commands.h"
#include "ripstop/base/error.h"
#include "ripstop/numeric/symmetric_solver.h"
#include "ripstop/version.h"

int main(int argc, char** argv) {
    using namespace ripstop;
    CLI::App app("Ripstop turns a 3D envelope divided into tiles by its seams into flat cut patterns.", "ripstop");
    app.set_version_flag("--version",
                         fmt::format("ripstop {}\nsources Apache-2.0; built with {}", version, numeric_libraries()));
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 all manufacturable, 1 some not (all files written), 2 usage, 3 unusable input, 4 our fault.");
    cli::add_flatten(app);
    cli::add_methods(app);
    cli::add_design(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::RuntimeError& result) {
        return result.get_exit_code();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? cli::manufacturable : cli::usage;
    } catch (const InputError& error) {
        fmt::print(stderr, "ripstop: {}\n", error.what());
        return cli::unusable_input;
    } catch (const std::exception& error) {
        fmt::print(stderr, "ripstop: this is our fault, please report it: {}\n", error.what());
        return cli::our_fault;
    }
    return cli::manufacturable;
}
