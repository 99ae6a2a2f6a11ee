/// ripstop design special: joins primitives into one body and cuts it into tiles.
#include <fmt/format.h>

#include <map>
#include <numbers>
#include <string>

#include "commands/design_file.h"
#include "help/progress_bar.h"
#include "help/tell.h"
#include "ripstop/base/text/units.h"
#include "ripstop/design/special/special.h"
#include "ripstop/design/tools/tiles_summary.h"
#include "ripstop/io/json/special_json.h"
#include "ripstop/io/text/input_file.h"

namespace ripstop::cli {
namespace {

struct DesignSpecialArguments {
    std::filesystem::path shape, file;
    bool force = false;
};

/// `BODY 96, EAR-L 12`: a tile's name consists of its primitive, sector and ring.
std::string tiles_by_primitive(const SpecialShape& shape, const std::vector<NamedMesh>& tiles) {
    std::map<std::string, int> counts;
    for (const NamedMesh& tile : tiles) ++counts[tile.name.substr(0, tile.name.rfind("-S"))];
    std::string text;
    for (const SpecialPrimitive& primitive : shape.primitives)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", primitive.name, counts[primitive.name]);
    return text;
}

void print_summary(const SpecialShape& shape, const std::vector<NamedMesh>& tiles) {
    const TilesSummary summary = measure_tiles(tiles);
    const int handles = (2 - summary.openings - summary.euler) / 2;
    print("{} tiles ({})\n", summary.tiles, tiles_by_primitive(shape, tiles));
    print("{} triangles; Euler number {}: {} opening{}, {} handle{}\n", summary.triangles, summary.euler,
          summary.openings, summary.openings == 1 ? "" : "s", handles, handles == 1 ? "" : "s");
    print("area {:.2f} m2, volume {:.2f} m3, height {:.3f} m\n", summary.area, summary.volume, summary.height);
    if (summary.openings > 0)
        print("mouth {:.3f} m around, like a circle {:.3f} m across\n", summary.rim, summary.rim / std::numbers::pi);
    print("tiles up to {:.3f} m long and {:.3f} m wide; edges {:.3f} to {:.3f} m, smallest angle {:.1f} degrees\n",
          summary.tile_length, summary.tile_width, summary.edge_min, summary.edge_max, summary.angle_min / degree);
    print("triangles turn by up to {:.2f} degrees at an edge, {:.2f} mm off the surface\n", summary.turn_max / degree,
          summary.chord_error / millimetre);
}

void run(const DesignSpecialArguments& given) {
    require_design_file(given.file, given.force);
    std::ifstream in = open_input(given.shape, "the special shape");
    const SpecialShape shape = read_special_shape(in, given.shape.string());
    const std::vector<NamedMesh> tiles = [&] {
        const Waiting waiting("Writing " + given.file.filename().string(), false);
        std::vector<NamedMesh> designed = design_special(shape);
        write_design_file(given.file, designed);
        return designed;
    }();
    print_summary(shape, tiles);
    print("{}\n", given.file.string());
}

}  // namespace

void add_design_special(CLI::App& shapes) {
    auto given = std::make_shared<DesignSpecialArguments>();
    CLI::App* special = shapes.add_subcommand(
        "special", "Write a special shape: ellipsoids, tori, capsules and cones, joined, in tiles by sector and ring");
    special->add_option("SHAPE", given->shape, "What it is made of, as JSON (docs/special.md)")
        ->type_name("FILE")
        ->required();
    special
        ->add_option("-o,--output", given->file,
                     "The file to write, in metres; its extension chooses the format: .obj, .ply, .stl, .off; tile "
                     "BODY-S03R02 is primitive BODY, sector 3, ring 2 (OFF has no names)")
        ->type_name("FILE")
        ->required();
    special->add_flag("--force", given->force, "Replace the file if it exists");
    special->footer(
        "SHAPE of a sphere in 8 sectors by 4 rings, open at the bottom:\n"
        "  {\"edge_mm\": 250, \"mouth_height_mm\": -2700, \"primitives\": [{\"name\": \"BODY\",\n"
        "   \"type\": \"ellipsoid\", \"radii_mm\": [3000, 3000, 3000], \"sectors\": 8, \"rings\": 4}]}\n\n"
        "Examples:\n"
        "  ripstop design special shape.json -o bear.obj\n"
        "  ripstop design special shape.json --force -o bear.ply\n\n"
        "Exit codes: 0 written, 2 usage, 3 the shape or the file cannot be made.");
    special->callback([given] { run(*given); });
}

}  // namespace ripstop::cli
