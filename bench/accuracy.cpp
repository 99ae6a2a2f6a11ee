/// Prints the accuracy table of the README as Markdown: the tiles of the test zoo, the designed envelope and the real input
/// in ../shared/data where it is, by the methods named on the command line (`seam-exact` and `paper` if none).
#include <fmt/format.h>

#include <filesystem>
#include <numbers>

#include "ripstop/design/gores.h"
#include "ripstop/io/fabric_json.h"
#include "ripstop/measure/judge.h"
#include "ripstop/pipeline/flatten_envelope.h"
#include "ripstop/pipeline/read_envelope.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

struct Row {
    std::string name;
    Envelope envelope;
    std::string fabric = "isotropic";
};

Row single(const std::string& name, const TriangleMesh& mesh, const Vec3& warp,
           const std::string& fabric = "isotropic") {
    return {name + ", " + fabric, {{make_tile("tile", mesh, {.warp = warp})}}, fabric};
}

std::vector<Row> zoo() {
    const double pi = std::numbers::pi;
    std::vector<Row> rows = {
        single("ruled cone", testing::cone(0.4, 2.4, 0.5, 2, 24, 16), Vec3::UnitZ()),
        single("ruled cylinder", testing::cylinder(2, 1.1, 1.5, 20, 16), Vec3::UnitZ()),
        single("tangent developable of a helix", testing::tangent_developable(1, 0.6, 0.8, 0.6, 1.4, 24, 12),
               Vec3::UnitZ()),
        single("staggered cone", testing::staggered_cone(0.4, 2.4, 0.5, 2, 36, 24), Vec3::UnitZ()),
        single("quarter sphere (90 degree lune)", testing::lune(pi / 2, 24, 48), Vec3::UnitZ()),
        single("octant of a sphere", testing::octant(24), Vec3(-1, 1, 0)),
        single("gore of 12", testing::lune(pi / 6, 10, 72), Vec3::UnitZ()),
        single("gore of 24", testing::lune(pi / 12, 8, 96), Vec3::UnitZ()),
        single("saddle", testing::saddle(1, 0.4, 24), Vec3::UnitX()),
    };
    rows.push_back({"envelope 24 x 15, nylon", make_envelope(design_natural({}), {}), "nylon"});
    const std::filesystem::path shared = "../shared/data";
    const auto add = [&](const std::string& name, const std::filesystem::path& file, double metres_per_unit) {
        if (std::filesystem::exists(shared / file))
            rows.push_back({name, read_envelope(shared / file, {.metres_per_unit = metres_per_unit}), "isotropic"});
    };
    add("dress, draped, 14 panels", "dress/dress_knife_drape_3d.obj", 1);
    add("dress, planar design, 14 panels", "dress/dress_knife_design_stage_3d.obj", 1);
    add("skirt", "skirt/skirt__skirt_3D_0.obj", 0.01);
    return rows;
}

/// The worst of every figure over the tiles of a row.
void print(const Row& row, const std::string& method) {
    FlattenOptions options;
    options.method = method;
    options.fabric = fabric_named(row.fabric);
    options.tolerances = tolerances_of(options.fabric);
    const CutPlan plan = flatten_envelope(row.envelope, options);
    const auto worst = [&](auto figure) {
        double largest = 0;
        for (const FlatTile& tile : plan.tiles)
            if (std::abs(figure(tile.accuracy)) >= std::abs(largest)) largest = figure(tile.accuracy);
        return 100 * largest;
    };
    int triangles = 0, flipped = 0, passed = 0;
    for (const FlatTile& tile : plan.tiles) {
        triangles += tile.tile.mesh.triangle_count();
        flipped += tile.accuracy.flipped;
        passed += tile.verdict.manufacturable() ? 1 : 0;
    }
    fmt::print("| {} | {} | {} | {:+.5f} | {:.4f} | {:+.5f} | {:.5f} | {:.5f} | {:.3f} | {:.2f} | {} | {} of {} |\n",
               row.name, triangles, method, worst([](const Accuracy& a) { return a.area_error; }),
               worst([](const Accuracy& a) { return a.area_error_abs; }),
               worst([](const Accuracy& a) { return a.perimeter_error; }),
               worst([](const Accuracy& a) { return a.boundary_error_max; }),
               worst([](const Accuracy& a) { return a.edge_error_abs; }), worst([](const Accuracy& a) {
                   return std::max({a.warp_strain_max, a.weft_strain_max, -a.warp_strain_min, -a.weft_strain_min});
               }),
               worst([](const Accuracy& a) { return a.shear_max; }) / 100 / degree, flipped, passed, plan.tiles.size());
}

}  // namespace
}  // namespace ripstop

int main(int argc, char** argv) {
    std::vector<std::string> methods(argv + 1, argv + argc);
    if (methods.empty()) methods = {"seam-exact", "paper"};
    fmt::print(
        "| tile, fabric | triangles | method | area % | sum of abs(dA) % | perimeter % | worst boundary edge % | sum "
        "of abs(dL), all edges % | "
        "strain % | shear deg | flips | made |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const ripstop::Row& row : ripstop::zoo())
        for (const std::string& method : methods) ripstop::print(row, method);
}
