/// ripstop design natural: writes a natural-shape hot-air balloon, divided into gores and panels.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "commands/commands.h"
#include "commands/design_file.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/design/natural/design_summary.h"

namespace ripstop::cli {
namespace {

struct DesignArguments {
    EnvelopeDesign design;
    std::filesystem::path file;
    std::string edge, crown, panel_height;
    double lobes = 0;
    std::optional<int> triangles;
    bool force = false;
};

/// Parses a length that must be positive: zero means "default" internally.
double positive_length(const std::string& text, const std::string& option) {
    const double length = parse_length(text, option);
    if (!(length > 0)) throw InputError(option + ": " + text + " is too little; give a length above 0");
    return length;
}

void print_summary(const DesignSummary& summary) {
    const NaturalShape& shape = summary.shape;
    const int handles_closed = summary.euler + summary.openings;
    print("{} tiles, {} panels per gore, {} triangles; Euler number {} with {} openings, {} for a sphere\n",
          summary.tiles, summary.panels, summary.triangles, summary.euler, summary.openings,
          handles_closed == 2 ? "right" : "WRONG");
    print("                    as drawn   equilibrium\n");
    print("height [m]        {:10.3f}    {:10.3f}\n", summary.height, shape.height);
    print("diameter [m]      {:10.3f}    {:10.3f}\n", summary.diameter, 2 * shape.max_radius);
    print("area [m2]         {:10.2f}    {:10.2f}\n", summary.area, shape.area);
    print("volume [m3]       {:10.1f}    {:10.1f}\n", summary.volume, shape.volume);
    print("gore length {:.3f} m, load {:.0f} N, crown pressure {:.1f} Pa, (F + W) / bV - 1 = {:.1e}\n", shape.length,
          shape.load, shape.crown_pressure, shape.imbalance);
    print("panels {:.3f} m high, up to {:.3f} m wide; edges {:.3f} to {:.3f} m, smallest angle {:.1f} degrees\n",
          summary.panel_height, summary.panel_width, summary.edge_min, summary.edge_max, summary.angle_min / degree);
    print("triangles turn by up to {:.2f} degrees at an edge, {:.2f} mm off the surface\n", summary.turn_max / degree,
          summary.chord_error / millimetre);
}

void run(DesignArguments given) {
    require_design_file(given.file, given.force);
    EnvelopeDesign& design = given.design;
    design.bulge = given.lobes * degree;
    if (!given.crown.empty()) design.crown_radius = parse_length(given.crown, "--crown");
    if (!given.panel_height.empty()) design.panel_height = positive_length(given.panel_height, "--panel-height");
    if (!given.edge.empty()) design.edge_length = parse_length(given.edge, "--edge");
    if (given.triangles) design.edge_length = edge_length_for(design, *given.triangles);
    const DesignSummary summary = [&] {
        const Waiting waiting("Writing " + given.file.filename().string(), false);
        const std::vector<NamedMesh> tiles = design_natural(design);
        write_design_file(given.file, tiles);
        return measure_design(design, tiles);
    }();
    print_summary(summary);
    print("{}\n", given.file.string());
}

void add_division_and_mesh(CLI::App& natural, DesignArguments& given) {
    natural.add_option("--gores", given.design.gores, "Number of gores")
        ->capture_default_str()
        ->type_name("N")
        ->group("Division");
    auto* panels =
        natural.add_option("--panels", given.design.panels, "Number of panels per gore, from the mouth to the crown")
            ->capture_default_str()
            ->type_name("N")
            ->group("Division");
    natural
        .add_option("--panel-height", given.panel_height,
                    "Instead of --panels: the largest height of a panel, such as 1450mm")
        ->excludes(panels)
        ->type_name("LENGTH")
        ->group("Division");
    auto* edge = natural.add_option("--edge", given.edge, "Length of a triangle's edge (default 150mm)")
                     ->type_name("LENGTH")
                     ->group("Mesh");
    natural.add_option("--triangles", given.triangles, "Instead of --edge: approximate number of triangles per tile")
        ->excludes(edge)
        ->type_name("N")
        ->group("Mesh");
}

void add_shape_and_load(CLI::App& natural, DesignArguments& given) {
    natural.add_option("--volume", given.design.volume, "Cubic metres, as if closed at the crown")
        ->capture_default_str()
        ->type_name("M3")
        ->group("Shape");
    natural.add_option("--mouth", given.design.mouth_ratio, "Radius of the mouth relative to the largest; 0: closed")
        ->capture_default_str()
        ->type_name("RATIO")
        ->group("Shape");
    natural.add_option("--crown", given.crown, "Radius of the opening at the top; 0m: closed (default 250mm)")
        ->type_name("LENGTH")
        ->group("Shape");
    natural.add_option("--lobes", given.lobes, "Half-angle of the lobes between load tapes; 0: smooth")
        ->capture_default_str()
        ->type_name("DEGREES")
        ->group("Shape");
    natural.add_option("--inside", given.design.air.inside, "Temperature of the hot air, Celsius")
        ->capture_default_str()
        ->type_name("C")
        ->group("Load");
    natural.add_option("--outside", given.design.air.outside, "Temperature outside, Celsius")
        ->capture_default_str()
        ->type_name("C")
        ->group("Load");
    natural.add_option("--altitude", given.design.air.altitude, "Pressure altitude, metres")
        ->capture_default_str()
        ->type_name("M")
        ->group("Load");
    natural.add_option("--mass", given.design.fabric_mass, "Mass of the cloth, kg/m2")
        ->capture_default_str()
        ->type_name("KG/M2")
        ->group("Load");
}

}  // namespace

void add_design(CLI::App& app) {
    CLI::App* shapes = app.add_subcommand("design", "Design an envelope and write it to a file");
    shapes->require_subcommand(1);
    shapes->footer(
        "Examples:\n  ripstop design natural -o envelope.obj\n"
        "  ripstop design special shape.json -o bear.obj\n"
        "`ripstop design natural --help` and `ripstop design special --help` list their options.");
    auto given = std::make_shared<DesignArguments>();
    CLI::App* natural = shapes->add_subcommand(
        "natural", "Write the natural shape of a hot-air balloon, without hoop tension, in gores and panels");
    natural
        ->add_option(
            "-o,--output", given->file,
            "The file to write, in metres; its extension chooses the format: .obj, .ply, .stl, .off; tile G01P01 is "
            "gore 1, panel 1 from the mouth (OFF has no names)")
        ->type_name("FILE")
        ->required();
    add_division_and_mesh(*natural, *given);
    add_shape_and_load(*natural, *given);
    natural->add_flag("--force", given->force, "Replace the file if it exists");
    natural->footer(
        "Examples:\n"
        "  ripstop design natural -o envelope.obj\n"
        "  ripstop design natural --gores 12 --panels 6 --volume 600 -o small.obj\n"
        "  ripstop design natural --panel-height 1450mm --lobes 12 -o lobed.ply\n\n"
        "Exit codes: 0 written, 2 usage, 3 no such shape exists, or the file cannot be written.");
    natural->callback([given] { run(*given); });
    add_design_special(*shapes);
}

}  // namespace ripstop::cli
