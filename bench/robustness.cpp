/// Prints how seam-exact flattening ends on hard tiles, from every start, with ever weaker shear, as Markdown for
/// docs/methods/seam-exact.md.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace {

/// `12 ok`: the number of factorisations and how it ended; `saddle` if the end is no strict minimum.
std::string ending(const Tile& tile, const Fabric& fabric, SeamStart start) {
    const Flattening flat = flatten_seam_exact(tile, fabric, {.start = start});
    const Accuracy found = measure_accuracy(tile, flat.positions, fabric);
    std::string end = "not reached";
    if (flat.summary.termination == Termination::converged)
        end = flat.certificate->strict_minimum && found.boundary_error_max < 1e-8 ? "ok" : "no strict minimum";
    if (found.flipped > 0) end += ", flips";
    return fmt::format("{} {}", flat.summary.factorizations, end);
}

}  // namespace
}  // namespace ripstop

int main() {
    using namespace ripstop;
    const std::pair<const char*, TriangleMesh> tiles[] = {
        {"quarter sphere", testing::lune(std::numbers::pi / 2, 12, 24)},
        {"octant", testing::octant(12)},
        {"hemisphere", testing::cap(std::numbers::pi / 2, 8)},
        {"saddle", testing::saddle(1.5, 0.5, 12)},
        {"sliver 250:1",
         testing::grid(3, 60, [](double u, double v) { return Vec3(0.004 * u, std::sin(2 * v), std::cos(2 * v)); })},
        {"10:1 triangles", testing::grid(40, 4, [](double u, double v) {
             return Vec3(std::sin(0.4 * (u - 0.5)), std::sin(0.4 * (v - 0.5)), std::cos(0.5 * (u + v))).normalized();
         })}};
    fmt::print("| tile | G/E | as it goes | from ARAP | from LSCM | from Tutte |\n|---|---|---|---|---|---|\n");
    for (const auto& [name, mesh] : tiles)
        for (const double shear : {0.5, 0.01, 0.002}) {
            Fabric fabric;
            fabric.shear_stiffness = 1000 * shear;
            const Tile tile = make_tile(name, mesh, {.warp = Vec3(0.3, 0.2, 1)});
            fmt::print("| {} | {} | {} | {} | {} | {} |\n", name, shear,
                       ending(tile, fabric, SeamStart::boundary_first), ending(tile, fabric, SeamStart::arap),
                       ending(tile, fabric, SeamStart::lscm), ending(tile, fabric, SeamStart::tutte));
        }
}
