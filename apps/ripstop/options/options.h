#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/pipeline/plan.h"

/// Options that several commands share.
namespace ripstop::cli {

struct InputArguments {
    std::filesystem::path file;
    std::string unit;     ///< empty: the project's, else metres
    std::string project;  ///< empty: none
    std::string fabric;   ///< of tiles that state none; empty: the project's, else isotropic
    std::string method = "seam-exact";
    bool keep_area = false;
    double grain = 0;            ///< [degrees]
    std::string seam_tolerance;  ///< a length with its unit; empty: the project's, else 0.5 mm
    std::string chord, edge;     ///< lengths with units, for meshing CAD surfaces; empty: by accuracy
    std::string tiles_are = "faces";
    std::vector<std::string> tiles;
    std::vector<std::string> layers;
    bool fair_seams = false;          ///< if the command has the option
    bool size_is_meant = false;       ///< accept the unit without a warning
    std::vector<std::string> accept;  ///< if the command has the option: codes of intended issues
    std::string remesh = "never";     ///< if the command has the option: `auto`, `never` or a length with its unit
};

void add_input_options(CLI::App& command, InputArguments& given);

/// Options for meshing CAD surfaces: `--chord`, `--edge`, `--tiles`. The second function throws InputError.
void add_meshing_options(CLI::App& command, std::string& chord, std::string& edge, std::string& tiles_are);
MeshingOptions meshing_of(const std::string& chord, const std::string& edge, const std::string& tiles_are);

void add_remesh_option(CLI::App& command, InputArguments& given);
void add_accept_option(CLI::App& command, InputArguments& given);
void add_method_option(CLI::App& command, InputArguments& given);

/// The method's name, with `--keep-area` applied. Throws a usage error if the method cannot keep the area.
std::string method_of(const InputArguments& given);

/// Reads a project file; nothing if `file` is empty. Throws InputError.
std::optional<Project> project_of(const std::string& file, const std::string& unit);

/// The job from the arguments and the project file, `completed`; arguments override the project. Throws
/// InputError.
Job job_of(const InputArguments& given);

/// Reads the input file. Writes its remarks, and at once any doubt about its unit, to stderr. Throws InputError.
EnvelopeInput read(const InputArguments& given, const Job& job, bool quiet);

/// Writes the remarks of an input to stderr; only the first ones if there are many.
void tell_remarks(const EnvelopeInput& input);

/// The issues of the envelope as given, for `check` and `flatten` alike (`judge_input`).
EnvelopeCheck judge_envelope(const Job& job, const EnvelopeInput& read);

/// Writes a warning to stderr for each entry of the project that matches nothing.
void tell_unused(const std::vector<std::string>& unused);

/// `CLI::Validator`s for names that the library looks up: they give the look-up's message, and exit code 2.
CLI::Validator known_method();
CLI::Validator known_unit();

}  // namespace ripstop::cli
