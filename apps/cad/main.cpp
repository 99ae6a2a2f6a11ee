/// ripstop-cad turns the surfaces of a CAD file into meshes for ripstop. It is a separate process because it
/// contains code under the GPL (gmsh), and because it may crash on a faulty file.
#include <fcntl.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <CLI/CLI.hpp>
#include <Standard_Failure.hxx>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "contained.h"
#include "meshing.h"
#include "ripstop/base/error.h"
#include "ripstop/version.h"

namespace {

enum ExitCode { done = 0, usage = 2, unusable_input = 3, our_fault = 4 };

struct Arguments {
    std::filesystem::path input, output;
    std::string chord, edge, tolerance;
    std::optional<double> metres_per_unit;
};

/// The kernels print banners and statistics; they must not appear on standard output.
void silence_stdout() {
    std::fflush(stdout);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if (nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
}

ripstop::MeshingOptions options_of(const Arguments& given) {
    ripstop::MeshingOptions options;
    if (!given.chord.empty()) options.chord_error = ripstop::parse_length(given.chord, "--chord");
    if (!given.edge.empty()) options.edge_length = ripstop::parse_length(given.edge, "--edge");
    if (!given.tolerance.empty()) options.sewing_tolerance = ripstop::parse_length(given.tolerance, "--tolerance");
    options.metres_per_unit = given.metres_per_unit;
    ripstop::require_sound(options);
    return options;
}

int convert(const Arguments& given, const ripstop::MeshingOptions& options, ripstop::cad::Reading reading,
            const ripstop::cad::Attempt* attempt) {
    using namespace ripstop;
    cad::Drawing drawing = cad::read_drawing(given.input, reading);
    if (attempt != nullptr) attempt->past();
    const ConvertedModel model = cad::convert(std::move(drawing), options);
    std::ofstream out(given.output, std::ios::binary);
    write_converted(out, model);
    out.flush();
    if (!out) throw InputError(given.output.string() + ": cannot be written; is there room on the disk?");
    return done;
}

int run(const Arguments& given) {
    using namespace ripstop::cad;
    const ripstop::MeshingOptions options = options_of(given);
    silence_stdout();
    if (!has_names(given.input)) return convert(given, options, Reading::with_names, nullptr);
    const Attempt attempt;
    if (attempt.is_here()) return convert(given, options, Reading::with_names, &attempt);
    if (const std::optional<int> code = attempt.end(unusable_input)) return *code;
    return convert(given, options, Reading::plain, nullptr);
}

int failed(const char* message, ExitCode code) {
    std::fprintf(stderr, "ripstop-cad: %s\n", message);
    return code;
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __linux__
    // If the caller was killed, nobody waits for the meshes.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    CLI::App app("Meshes the surfaces of STEP, IGES and BREP files; ripstop runs it when needed.", "ripstop-cad");
    app.set_version_flag("--version", std::string("ripstop-cad ") + ripstop::version);
    Arguments given;
    app.add_option("INPUT", given.input, "A .step, .stp, .iges, .igs, .brep, .brp or .converted file")->required();
    app.add_option("OUTPUT", given.output, "The meshes, as ripstop reads them")->required();
    app.add_option("--chord", given.chord, "Largest distance of the surface from its triangles, such as 0.2mm");
    app.add_option("--edge", given.edge, "Largest edge length, such as 100mm");
    app.add_option("--tolerance", given.tolerance, "Faces whose edges are this close are sewn (default 0.5mm)");
    app.add_option("--metres-per-unit", given.metres_per_unit, "Overrides the unit of the file");
    try {
        app.parse(argc, argv);
        return run(given);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : usage;
    } catch (const ripstop::InputError& error) {
        return failed(error.what(), unusable_input);
    } catch (const Standard_Failure& error) {
        return failed(error.GetMessageString(), our_fault);
    } catch (const std::exception& error) {
        return failed(error.what(), our_fault);
    }
}
