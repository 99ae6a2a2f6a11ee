/// Prints the gain of matching neighbours over seams as drawn, as Markdown for docs/methods/seam-matched.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "ripstop/design/natural/gores.h"
#include "ripstop/flatten/method.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/measure/judge.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "support/sewn.h"

namespace ripstop {
namespace {

void print_row(const std::string& name, const Envelope& envelope, const Fabric& fabric, const std::string& method) {
    FlattenOptions options;
    options.method = method;
    options.fabric = fabric;
    options.tolerances = tolerances_of(fabric);
    const std::clock_t start = std::clock();
    const CutPlan plan = flatten_envelope(envelope, options);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;  // of all threads
    double energy = 0, least = 1, most = -1, strain = 0, longest = 0, factorizations = 0;
    int rounds = 0, good = 0;
    std::vector<Points2> flats;
    for (const FlatTile& tile : plan.tiles) {
        const Accuracy& found = tile.accuracy;
        energy += found.energy;
        least = std::min(least, found.area_error);
        most = std::max(most, found.area_error);
        strain = std::max({strain, std::abs(found.warp_strain_min), std::abs(found.warp_strain_max),
                           std::abs(found.weft_strain_min), std::abs(found.weft_strain_max)});
        longest = std::max(longest, found.boundary_error_max);
        rounds = std::max(rounds, tile.flattening.summary.iterations);
        factorizations += tile.flattening.summary.factorizations;
        good += tile.flattening.summary.termination == Termination::converged && tile.flattening.certificate &&
                tile.flattening.certificate->strict_minimum;
        flats.push_back(tile.flattening.positions);
    }
    const auto count = plan.tiles.size();
    fmt::print(
        "| {} | {} | {:.4g} | {:+.3f} to {:+.3f} | {:.3f} | {:.3f} | {:.0e} | {} | {:.1f} | {} of {} | {:.2f} |\n",
        name, method, energy, 100 * least, 100 * most, 100 * strain, 100 * longest,
        testing::worst_drift(envelope, flats), rounds, factorizations / static_cast<double>(count), good, count,
        seconds);
}

void print_rows(const std::string& name, const Envelope& envelope, const Fabric& fabric) {
    for (const char* method : {"seam-exact", "seam-matched-0.1", "seam-matched"})
        print_row(name, envelope, fabric, method);
}

Fabric weak() {
    Fabric fabric = fabric_named("isotropic");
    fabric.shear_stiffness = 0.01 * fabric.warp_stiffness;
    return fabric;
}

}  // namespace
}  // namespace ripstop

int main() {
    using namespace ripstop;
    fmt::print(
        "| envelope | method | energy [J] | area [%] | strain [%] | edges from drawn [%] | mismatch | rounds | "
        "factorisations a tile | certified | processor seconds |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    const Fabric isotropic = fabric_named("isotropic");
    const Envelope gores = testing::gores({40 * degree, 20 * degree}, 12, 16, 72);
    print_rows("gores of 40 and 20 degrees, isotropic", gores, isotropic);
    print_rows("the same, G/E 0.01", gores, weak());
    print_rows("12 gores of 30 degrees, isotropic", testing::gores({30 * degree}, 12, 12, 72), isotropic);
    EnvelopeDesign design;
    design.edge_length = edge_length_for(design, 1000);
    Envelope balloon = make_envelope(design_natural(design), {});
    balloon.seams = testing::conforming_seams(balloon.tiles);
    print_rows("24 x 15, 1,000 triangles a tile, isotropic", balloon, isotropic);
    print_rows("the same, nylon", balloon, fabric_named("nylon"));
}
