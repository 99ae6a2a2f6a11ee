/// Prints the accuracy table of docs/accuracy.md: the tiles of the test zoo, the designed envelope and, if
/// present, the real input in ../shared/data, by the methods named on the command line (default: all).
///
///     ripstop-accuracy --check FILE     the ratchet: exits with 1 if a figure is worse than in the table of FILE
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/measure/judge.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

struct Row {
    std::string name;
    Envelope envelope;
    std::string fabric = "isotropic";
    bool real = false;  ///< input from others: printed but not compared, because crumpled cloth depends on rounding
};

Row single(const std::string& name, const TriangleMesh& mesh, const Vec3& warp,
           const std::string& fabric = "isotropic") {
    return {name + ", " + fabric, {{make_tile("tile", mesh, {.warp = warp})}}, fabric};
}

/// Between two circles of latitude near the poles, so that no vertex has too many triangles.
TriangleMesh one_way_gore(double angle, int columns, int rows) {
    return testing::grid(columns, rows, [angle](double u, double v) {
        const double longitude = angle * (u - 0.5), latitude = std::numbers::pi * 0.49 * (2 * v - 1);
        return Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
    });
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
        single("gore of 24, diagonals one way", one_way_gore(pi / 12, 8, 96), Vec3::UnitZ()),
        single("cap of 0.6", testing::cap(0.6, 16), Vec3::UnitX()),
        single("square of the sphere", testing::spherical_square(0.3, 16), Vec3::UnitX()),
        single("saddle", testing::saddle(1, 0.4, 24), Vec3::UnitX()),
        single("torus, inside", testing::torus_patch(3, 1, 0.5, 2.6, 3.7, 20, 20), Vec3::UnitZ()),
        single("coarse staggered cone", testing::staggered_cone(0.4, 2.4, 0.5, 2, 12, 6), Vec3::UnitZ()),
    };
    rows.push_back({"envelope 24 x 15, nylon", make_envelope(design_natural({}), {}), "nylon"});
    const std::filesystem::path shared = "../shared/data";
    const auto add = [&](const std::string& name, const std::filesystem::path& file, double metres_per_unit) {
        if (std::filesystem::exists(shared / file))
            rows.push_back(
                {name, read_envelope(shared / file, {.unit = LengthUnit{"", metres_per_unit}}), "isotropic", true});
    };
    add("dress, draped, 14 panels", "dress/dress_knife_drape_3d.obj", 1);
    add("dress, planar design, 14 panels", "dress/dress_knife_design_stage_3d.obj", 1);
    add("skirt", "skirt/skirt__skirt_3D_0.obj", 0.01);
    return rows;
}

/// A line of the table: the worst of every figure over the tiles of a row.
std::string line_of(const Row& row, const std::string& method) {
    FlattenOptions options;
    options.method = method;
    options.fabric = fabric_named(row.fabric);
    options.tolerances = tolerances_of(options.fabric);
    const CutPlan plan = flatten_envelope(row.envelope, options);
    const auto worst = [&](auto figure) {
        double largest = 0;
        for (const FlatTile& tile : plan.tiles)
            if (!(std::abs(figure(tile.accuracy)) < std::abs(largest))) largest = figure(tile.accuracy);
        return 100 * largest;
    };
    int triangles = 0, flipped = 0, passed = 0;
    for (const FlatTile& tile : plan.tiles) {
        triangles += tile.tile.mesh.triangle_count();
        flipped += tile.accuracy.flipped;
        passed += tile.verdict.manufacturable() ? 1 : 0;
    }
    return fmt::format(
        "| {} | {} | {} | {:+.5f} | {:.4f} | {:+.5f} | {:.5f} | {:.5f} | {:.3f} | {:.2f} | {} | {} of {} |", row.name,
        triangles, method, worst([](const Accuracy& a) { return a.area_error; }),
        worst([](const Accuracy& a) { return a.area_error_abs; }),
        worst([](const Accuracy& a) { return a.perimeter_error; }),
        worst([](const Accuracy& a) { return a.boundary_error_max; }),
        worst([](const Accuracy& a) { return a.edge_error_abs; }), worst([](const Accuracy& a) {
            return std::max({a.warp_strain_max, a.weft_strain_max, -a.warp_strain_min, -a.weft_strain_min});
        }),
        worst([](const Accuracy& a) { return a.shear_max; }) / 100 / degree, flipped, passed, plan.tiles.size());
}

/// The cells of a table line; empty for any other line.
std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> result;
    for (std::size_t at = line.find("| "); at != std::string::npos && at + 2 < line.size();) {
        const std::size_t end = line.find(" |", at + 2);
        if (end == std::string::npos) break;
        result.push_back(line.substr(at + 2, end - at - 2));
        at = end + 1;
    }
    return result;
}

/// True if a figure is farther from 0 than the kept one, beyond the rounding of another processor. NaN is always
/// worse.
bool is_worse(double now, double kept) {
    return !std::isfinite(now) || std::abs(now) > 1.02 * std::abs(kept) + 2e-4;
}

/// Which figures became worse than in the kept line; empty if none.
std::string worsening(const std::vector<std::string>& now, const std::vector<std::string>& kept) {
    constexpr std::size_t first_figure = 3, flips = 10, made = 11;
    static const char* const names[] = {"area",      "sum of abs(dA)", "perimeter", "boundary edge",
                                        "all edges", "strain",         "shear"};
    std::string text;
    const auto meaningless = [](const std::string& figure) { return std::abs(std::stod(figure)) > 100; };
    for (std::size_t i = first_figure; i < flips; ++i)
        if (!meaningless(kept[i]) && is_worse(std::stod(now[i]), std::stod(kept[i])))
            text += fmt::format(" {} {} was {};", names[i - first_figure], now[i], kept[i]);
    if (std::stoi(now[flips]) > std::stoi(kept[flips]))
        text += fmt::format(" flips {} was {};", now[flips], kept[flips]);
    if (std::stoi(now[made]) < std::stoi(kept[made])) text += fmt::format(" made {} was {};", now[made], kept[made]);
    return text;
}

/// Compares today's figures with a kept table: every method must be in every row, none missing and none worse.
/// Real input is skipped.
bool check(const std::vector<Row>& rows, const std::string& file) {
    std::ifstream in(file);
    std::map<std::pair<std::string, std::string>, std::vector<std::string>> kept;
    for (std::string line; std::getline(in, line);)
        if (const std::vector<std::string> cell = cells(line); cell.size() == 12) kept[{cell[0], cell[2]}] = cell;
    int worse = 0;
    for (const Row& row : rows) {
        if (row.real) continue;
        for (const Method& method : methods()) {
            const auto line = kept.find({row.name, method.name});
            const std::string text = line == kept.end() ? " no line in the table"
                                                        : worsening(cells(line_of(row, method.name)), line->second);
            if (text.empty()) continue;
            ++worse;
            fmt::print("worse: {}, {}:{}\n", row.name, method.name, text);
        }
    }
    fmt::print("{}: {} methods checked on every tile of the zoo, {} worse\n", file, methods().size(), worse);
    return worse == 0;
}

}  // namespace
}  // namespace ripstop

int main(int argc, char** argv) try {
    std::vector<std::string> methods(argv + 1, argv + argc);
    const std::vector<ripstop::Row> rows = ripstop::zoo();
    if (methods.size() == 2 && methods[0] == "--check") return ripstop::check(rows, methods[1]) ? 0 : 1;
    for (const std::string& method : methods) ripstop::method_named(method);
    if (methods.empty())
        for (const ripstop::Method& method : ripstop::methods()) methods.emplace_back(method.name);
    fmt::print(
        "| tile, fabric | triangles | method | area % | sum of abs(dA) % | perimeter % | worst boundary edge % | sum "
        "of abs(dL), all edges % | strain % | shear deg | flips | made "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const ripstop::Row& row : rows)
        for (const std::string& method : methods) fmt::print("{}\n", ripstop::line_of(row, method));
} catch (const ripstop::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
}
