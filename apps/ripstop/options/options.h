#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/pipeline/read/read_envelope.h"

/// The options that several commands share.
namespace ripstop::cli {

struct InputArguments {
    std::filesystem::path file;
    std::string unit;     ///< empty: the project's, else metres
    std::string project;  ///< empty: none
    std::string fabric;   ///< of tiles without one of their own; empty: the project's, else isotropic
    std::string method = "seam-exact";
    bool keep_area = false;
    double grain = 0;            ///< [degrees]
    std::string seam_tolerance;  ///< a length with its unit; empty: the project's, else half a millimetre
    std::string chord, edge;  ///< lengths with their units, of the meshes made of a CAD's surfaces; empty: by accuracy
    std::string tiles_are = "faces";
    std::vector<std::string> tiles;
    std::vector<std::string> layers;
    bool fair_seams = false;          ///< where the command has the option
    bool size_is_meant = false;       ///< the unit is not to be doubted
    std::vector<std::string> accept;  ///< where the command has the option: codes of issues that are meant
    std::string remesh = "never";     ///< where the command has the option: `auto`, `never` or a length with its unit
};

/// What the arguments and the project file say together; the command line goes before the project.
struct Input {
    ReadOptions read;
    Fabric fabric;
    Tolerances tolerances;
    std::vector<std::string> accept;  ///< codes of issues that are meant, those of the project too
};

void add_input_options(CLI::App& command, InputArguments& given);

/// How the surfaces of a CAD are meshed: `--chord`, `--edge`, `--tiles`. The second throws InputError.
void add_meshing_options(CLI::App& command, std::string& chord, std::string& edge, std::string& tiles_are);
MeshingOptions meshing_of(const std::string& chord, const std::string& edge, const std::string& tiles_are);

void add_remesh_option(CLI::App& command, InputArguments& given);
void add_accept_option(CLI::App& command, InputArguments& given);
void add_method_option(CLI::App& command, InputArguments& given);

/// The method's name, `--keep-area` taken in. Throws a usage error where the method cannot keep the area.
std::string method_of(const InputArguments& given);

/// The project of a file; nothing where no name is given. Throws InputError.
std::optional<Project> project_of(const std::string& file, const std::string& unit);

/// Throws InputError.
Input resolve(const InputArguments& given);

/// Reads the input file. Its remarks go to stderr, and at once what makes its unit doubtful. Throws InputError.
EnvelopeInput read(const InputArguments& given, const Input& input, bool quiet);

/// What is wrong with the envelope as it was given, for `check` and `flatten` alike (`judge_input`).
EnvelopeCheck judge_envelope(const InputArguments& given, const Input& input, const EnvelopeInput& read);

/// A warning on stderr for each entry of the project that fits nothing.
void tell_unused(const std::vector<std::string>& unused);

/// `CLI::Validator` texts for names that the library looks up: the message of the look-up, exit code 2.
CLI::Validator known_method();
CLI::Validator known_unit();

}  // namespace ripstop::cli
