#include "options/options.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>
#include <fstream>

#include "commands/known.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "options/guess.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/io/json/project_json.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "ripstop/io/text/input_file.h"
#include "ripstop/measure/judge.h"
#include "ripstop/pipeline/read/envelope_faults.h"
#include "ripstop/pipeline/read/tile_fabrics.h"

namespace ripstop::cli {
namespace {

constexpr std::size_t shown_remarks = 12;
constexpr const char* surfaces = "CAD surfaces (STEP, IGES, BREP, Rhino)";

/// Throws InputError if the file cannot be opened or read.

/// Throws InputError that suggests a similar preset.
Fabric fabric_of(const std::string& named, const std::optional<Project>& project) {
    try {
        return envelope_fabric(named, project);
    } catch (const InputError& error) {
        throw InputError(error.what() + guess(named, fabric_presets()));
    }
}

/// A flat input is judged on the mesh that it came with.
RemeshOptions remesh_options(const InputArguments& given) {
    RemeshOptions options;
    if (given.remesh == "never") return options;
    if (given.remesh == "auto") {
        if (given.method != "given") options.mode = RemeshMode::automatic;
        return options;
    }
    if (given.method == "given")
        throw CLI::ValidationError("--remesh " + given.remesh +
                                   " does not go with --method given: flat positions belong to the input's mesh");
    if (!std::isdigit(static_cast<unsigned char>(given.remesh.front())) && given.remesh.front() != '.')
        throw CLI::ValidationError("--remesh is \"" + given.remesh +
                                   "\", expected auto, never or a length with its unit, such as 50mm");
    options.mode = RemeshMode::by_length;
    options.edge_length = parse_length(given.remesh, "--remesh");
    return options;
}

}  // namespace

CLI::Validator known_method() {
    std::vector<std::string> names;
    for (const Method& method : methods()) names.emplace_back(method.name);
    names.emplace_back("given");
    const auto look_up = [](const std::string& name) {
        if (name == "given") return;
        try {
            method_named(name);
        } catch (const InputError& error) {
            throw InputError(std::string(error.what()) + ", given");
        }
    };
    return known(look_up, names);
}

CLI::Validator known_unit() {
    return known([](const std::string& unit) { metres_per_unit(unit); }, {"mm", "cm", "m", "in", "ft"});
}

void add_meshing_options(CLI::App& command, std::string& chord, std::string& edge, std::string& tiles_are) {
    command
        .add_option("--chord", chord,
                    "Largest distance of a surface from its triangles, such as 0.3mm (default: lengths to 0.01 %)")
        ->type_name("LENGTH")
        ->group(surfaces);
    command
        .add_option("--edge", edge, "Largest edge length of triangles, such as 100mm (default: as --chord requires)")
        ->type_name("LENGTH")
        ->group(surfaces);
    command.add_option("--tiles", tiles_are, "What a tile is: each face of a model, or each object of several faces")
        ->capture_default_str()
        ->type_name("WORD")
        ->check(one_of({"faces", "objects"}))
        ->group(surfaces);
}

MeshingOptions meshing_of(const std::string& chord, const std::string& edge, const std::string& tiles_are) {
    MeshingOptions options;
    if (!chord.empty()) options.chord_error = parse_length(chord, "--chord");
    if (!edge.empty()) options.edge_length = parse_length(edge, "--edge");
    if (const char* mesher = std::getenv("RIPSTOP_CAD")) options.mesher = mesher;
    options.tiles = tiles_are == "objects" ? TilesAs::objects : TilesAs::faces;
    return options;
}

void add_input_options(CLI::App& command, InputArguments& given) {
    std::string formats;
    for (const MeshFormat& format : mesh_formats())
        formats += (formats.empty() ? "" : ", ") + std::string(format.extension);
    for (const CadFormat& format : cad_formats()) formats += ", " + std::string(format.extension);
    command.add_option("INPUT", given.file, "The envelope, one object, group, part or face per tile: " + formats)
        ->type_name("FILE")
        ->required();
    command
        .add_option("--unit", given.unit,
                    "Unit of the file's numbers (default: the project's, then the file's own, then metres)")
        ->group("Input")
        ->type_name("UNIT")
        ->check(known_unit());
    command
        .add_flag("--size-is-meant", given.size_is_meant,
                  "The size is right, although unusual for a balloon: accept the unit (also in the project)")
        ->group("Input");
    command
        .add_option("--project", given.project,
                    "JSON with what the file cannot say: names, warp, corners, fabrics, seam types, tolerances "
                    "(docs/project.md)")
        ->group("Input")
        ->type_name("FILE.json");
    command
        .add_option(
            "--fabric", given.fabric,
            "Fabric of the tiles without one of their own: isotropic, nylon, nylon-silicone, polyester or a JSON "
            "file (default: the project's, then isotropic)")
        ->group("Input")
        ->type_name("FILE.json")
        ->check(known([](const std::string&) {}, fabric_presets()));  // checked once the project is known
    command
        .add_option("--grain", given.grain,
                    "Turn the warp from each tile's longest axis, degrees counter-clockwise seen from outside")
        ->group("Input")
        ->type_name("DEGREES")
        ->check(within(-360.0, 360.0));
    command
        .add_option("--seam-tolerance", given.seam_tolerance,
                    "Edges to be sewn together lie within this distance (default: the project's, then 0.5mm)")
        ->group("Input")
        ->type_name("LENGTH");
    add_meshing_options(command, given.chord, given.edge, given.tiles_are);
    // One name at a time, else `--tile G01 envelope.obj` would take the input for a second name.
    command
        .add_option("--tile", given.tiles,
                    "Only the tiles of this name; * and ? stand for other letters; may be repeated")
        ->group("Input")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command
        .add_option("--layer", given.layers,
                    "Only objects on layers of this name, a full path such as a::b (default: the project's); * and ? "
                    "as above; may be repeated")
        ->group("Input")
        ->type_name("NAME")
        ->allow_extra_args(false);
}

void add_remesh_option(CLI::App& command, InputArguments& given) {
    given.remesh = "auto";
    command
        .add_option("--remesh", given.remesh,
                    "Remesh tiles: auto (those with too coarse, too poor or too fine a mesh), never, or an edge "
                    "length for all, such as 50mm")
        ->group("Flattening")
        ->type_name("WORD")
        ->capture_default_str();
}

void add_accept_option(CLI::App& command, InputArguments& given) {
    const std::vector<std::string> codes(acceptable_issues.begin(), acceptable_issues.end());
    command
        .add_option("--accept", given.accept,
                    "Accept a fault that is intended, which then becomes a note: missing_tile (openings with corners); "
                    "separate several codes with commas (also in the project)")
        ->group("Input")
        ->type_name("CODES")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(one_of(codes));
}

void add_method_option(CLI::App& command, InputArguments& given) {
    command.add_option("--method", given.method, "How to flatten; `ripstop methods` lists them")
        ->capture_default_str()
        ->group("Flattening")
        ->type_name("NAME")
        ->check(known_method());
    command
        .add_flag("--keep-area", given.keep_area,
                  "Keep the whole area exact too (method seam-exact-area), at the cost of more strain")
        ->group("Flattening");
}

std::string method_of(const InputArguments& given) {
    if (!given.keep_area) return given.method;
    if (given.method != "seam-exact" && given.method != "seam-exact-area")
        throw CLI::ValidationError("--keep-area goes with --method seam-exact, not " + given.method);
    return "seam-exact-area";
}

std::optional<Project> project_of(const std::string& file, const std::string& unit) {
    if (file.empty()) return std::nullopt;
    std::ifstream in = open_input(file, "the project file");
    return read_project(in, file, unit);
}

Job job_of(const InputArguments& given) {
    Job job;
    job.read.project = project_of(given.project, given.unit);
    if (!given.unit.empty()) job.read.unit = LengthUnit{given.unit, metres_per_unit(given.unit)};
    job.read.size_is_meant = given.size_is_meant;
    job.read.grain_turn = given.grain * degree;
    job.read.only = given.tiles;
    job.read.layers = given.layers;
    if (!given.seam_tolerance.empty()) job.seam_tolerance = parse_length(given.seam_tolerance, "--seam-tolerance");
    job.accept = given.accept;
    job.fabric = fabric_of(given.fabric, job.read.project);
    job.read.meshing = meshing_of(given.chord, given.edge, given.tiles_are);
    if (given.fair_seams && given.method == "given")
        throw CLI::ValidationError(
            "--fair-seams does not go with --method given: flat positions belong to the input's mesh");
    job.read.fair_seams = given.fair_seams;
    job.read.remesh = remesh_options(given);
    return completed(std::move(job));
}

EnvelopeCheck judge_envelope(const Job& job, const EnvelopeInput& read) {
    return judge_input(read, {job.read.seam_tolerance, job.read.only.empty(), job.accept});
}

void tell_unused(const std::vector<std::string>& unused) {
    for (const std::string& sentence : unused) tell(fmt::format("Warning: {}\n", sentence));
}

void tell_remarks(const EnvelopeInput& input) {
    for (std::size_t i = 0; i < input.remarks.size(); ++i) {
        if (i == shown_remarks) {
            tell(fmt::format("Note: and {} more; report.json has them all\n", input.remarks.size() - i));
            break;
        }
        tell(fmt::format("Note: {}\n", input.remarks[i]));
    }
}

EnvelopeInput read(const InputArguments& given, const Job& job, bool quiet) {
    EnvelopeInput read = [&] {
        Waiting waiting("Reading " + given.file.filename().string(), quiet);
        ReadOptions options = job.read;
        options.meshing.progress = waiting.progress();
        options.doubts = [&](const UnitDoubt& doubt) {
            if (!quiet) tell(fmt::format("Warning: {}\n", doubt.sentence));
        };
        return read_input(given.file, options);
    }();
    if (!quiet) tell_remarks(read);
    return read;
}

}  // namespace ripstop::cli
