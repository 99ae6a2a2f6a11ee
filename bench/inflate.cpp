/// Prints the tables of docs/methods/inflation.md as Markdown: membranes with known shapes, designed shapes beside
/// their equation, and the cost of inflating and correcting a whole envelope of 24 gores of 15 panels.
///
///     ripstop-bench-inflate [validation | shapes | envelope]...     default: all
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>

#include "ripstop/inflate/inflate.h"
#include "ripstop/io/json/fabric_json.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/flight/compensate.h"
#include "ripstop/pipeline/flight/find_symmetry.h"
#include "support/balloons.h"
#include "support/membranes.h"

namespace ripstop {
namespace {

using namespace testing;

/// Prints one figure on several meshes.
void print_row(const std::string& what, const std::string& reference, const std::vector<int>& sizes,
               const std::vector<double>& found, int digits) {
    std::string figures, meshes;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        figures += fmt::format("{}{:.{}f}", i ? ", " : "", found[i], digits);
        meshes += fmt::format("{}{}", i ? ", " : "", sizes[i]);
    }
    fmt::print("| {} | {} | {} | {} |\n", what, reference, figures, meshes);
}

/// Several figures of one computation on several meshes.
template <class Result>
struct Figure {
    std::string name, reference;
    std::function<double(const Result&)> of;
    int digits = 5;
};

template <class Result>
void print_case(const std::string& name, const std::vector<int>& sizes, const std::function<Result(int)>& compute,
                const std::vector<Figure<Result>>& figures) {
    std::vector<Result> results;
    for (const int n : sizes) results.push_back(compute(n));
    for (const Figure<Result>& figure : figures) {
        std::vector<double> found;
        for (const Result& result : results) found.push_back(figure.of(result));
        print_row(name + ", " + figure.name, figure.reference, sizes, found, figure.digits);
    }
}

void print_validation() {
    fmt::print("| test | reference | computed | n |\n|---|---|---|---|\n");
    print_case<double>(
        "sphere", {4, 8, 16, 32}, sphere_stretch,
        {{"stretch", fmt::format("{:.6f}", sphere_stretch_exact), [](double stretch) { return stretch; }, 6}});
    print_case<Cylinder>("cylinder", {8, 16, 32}, cylinder_under_gas,
                         {{"S11 [N/m]", "1200", [](const Cylinder& each) { return each.hoop; }, 2},
                          {"stretch", fmt::format("{:.6f}", std::sqrt(1 + 2400 / balloon_nylon().c11())),
                           [](const Cylinder& each) { return each.stretch; }, 6}});
    for (const HenckyRow& row : hencky)
        print_case<Disk>(
            fmt::format("clamped disk, nu {}", row.poisson), {8, 16, 32, 64},
            [&](int n) { return clamped_disk(row.poisson, n); },
            {{"w0", fmt::format("{:.5f}", row.height), [](const Disk& each) { return each.height; }},
             {"N in the middle", fmt::format("{:.5f}", row.centre), [](const Disk& each) { return each.centre; }},
             {"N at the edge", fmt::format("{:.5f}", row.edge), [](const Disk& each) { return each.edge; }}});
    print_case<Mylar>(
        "Mylar balloon", {8, 16, 32}, [](int n) { return mylar_balloon(n); },
        {{"volume / a^3", fmt::format("{:.4f}", mylar_exact.volume), [](const Mylar& each) { return each.volume; }, 4},
         {"radius / a", fmt::format("{:.4f}", mylar_exact.radius), [](const Mylar& each) { return each.radius; }, 4},
         {"half the thickness / a", fmt::format("{:.4f}", mylar_exact.half),
          [](const Mylar& each) { return each.half; }, 4}});
    print_case<Airbag>("square airbag", {6, 12, 24}, [](int n) { return square_airbag(n); },
                       {{"height [m]", "0.216 to 0.217", [](const Airbag& each) { return each.height; }, 4},
                        {"corner comes in by [m]", "0.0494", [](const Airbag& each) { return each.corner; }, 4},
                        {"volume / side^3", "0.2045", [](const Airbag& each) { return each.volume; }, 4},
                        {"N in the middle [N/m]", "2300 to 2340", [](const Airbag& each) { return each.tension; }, 0}});
}

int triangles_of(const CutPlan& plan) {
    int count = 0;
    for (const FlatTile& tile : plan.tiles) count += tile.tile.mesh.triangle_count();
    return count;
}

/// The largest and the mean relative difference of the tapes' forces from those of the design.
std::string tape_errors(const EnvelopeDesign& design, const CutPlan& plan, const Inflated& found) {
    const std::vector<double> forces = tape_forces_by_design(design);
    double most = 0, sum = 0;
    for (const InflatedTape& tape : found.tapes) {
        if (tape.kind != TapeKind::load) continue;
        const int panel = plan.seams[static_cast<std::size_t>(tape.source)].a.tile % design.panels;
        const double expected = forces[static_cast<std::size_t>(panel)];
        const double error = std::abs(0.5 * (tape.force_min + tape.force_max) / expected - 1);
        most = std::max(most, error);
        sum += error / design.panels;
    }
    return most == 0 ? "-" : fmt::format("{:.1f}, {:.1f}", 100 * sum, 100 * most);
}

void print_shapes() {
    fmt::print(
        "| shape | triangles | off the drawn surface, rms, max [mm] | moved, rms, max [mm] | tapes against the "
        "equation, "
        "mean, max [%] |\n|---|---|---|---|---|\n");
    for (const double edge : {0.4, 0.2})
        for (const double bulge : {0.0, 20.0, 30.0}) {
            const EnvelopeDesign design{
                .gores = 24, .panels = 12, .crown_radius = 0.6, .bulge = bulge * degree, .edge_length = edge};
            const bool is_lobed = bulge > 0;
            const CutPlan plan =
                is_lobed ? cut_full_balloon(design, 0.03, Rigging{}.load_tape.stiffness) : cut_balloon(design, false);
            InflateOptions options;
            options.sewing.symmetry = find_symmetry(plan);
            if (!is_lobed) {
                options.sewing.stiffer = 100;
                options.sewing.rest = RestState::as_drawn;
            }
            const Inflated found = inflate(plan, options);
            fmt::print("| {} | {} | {:.1f}, {:+.1f} | {:.1f}, {:.1f} | {} |\n",
                       is_lobed ? fmt::format("lobed, {:.0f} degrees, 3 % fullness", bulge)
                                : "smooth, cloth 100 times stiffer",
                       triangles_of(plan), 1e3 * found.off.rms, 1e3 * found.off.max, 1e3 * found.off.moved_rms,
                       1e3 * found.off.moved_max, tape_errors(design, plan, found));
        }
}

double seconds_of(const std::function<void()>& work) {
    const auto begun = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

void print_envelope() {
    fmt::print(
        "| envelope, 24 x 15 | triangles | sectors | inflate s | factorisations | moved, rms [mm] | correct s | rounds "
        "| moved, "
        "rms [mm] | rms / height | volume | seams |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const double bulge : {0.0, 20.0})
        for (const bool use_symmetry : {true, false}) {
            EnvelopeDesign design{.bulge = bulge * degree};
            design.edge_length = edge_length_for(design, 50000 / (design.gores * design.panels));
            CompensateOptions options;
            options.flatten.fabric = fabric_named("nylon");
            options.inflate.use_symmetry = use_symmetry;
            options.inflate.find_causes = false;
            if (bulge > 0) {
                options.tapes = TapedSeams::meridians;
                options.inflate.rigging.foreshortening = 0.02;
            }
            const Envelope envelope = balloon(design);
            const CutPlan cut = cut_balloon(design, bulge > 0);
            Inflated once;
            const double inflating = seconds_of([&] { once = inflate_plan(cut, options.inflate); });
            CutPlan plan;
            const double correcting = seconds_of([&] { plan = compensate(envelope, options); });
            const Inflated& found = *plan.inflated;
            double worst = 0;
            for (const SeamWalk& walk : plan.walks) worst = std::max(worst, walk.drift_max / walk.length);
            fmt::print(
                "| {} | {} | {} | {:.1f} | {} | {:.1f} | {:.1f} | {} | {:.1f} | {:.3f} % | {:+.3f} % | {:.0e} |\n",
                bulge > 0 ? "lobed, 20 degrees, tapes 2 % shorter" : "smooth", triangles_of(plan), found.sectors,
                inflating, once.summary.factorizations, 1e3 * once.off.moved_rms, correcting, plan.rounds.size(),
                1e3 * found.off.moved_rms, 100 * found.off.moved_rms / found.drawn_height,
                100 * (found.volume / found.drawn_volume - 1), worst);
        }
}

}  // namespace
}  // namespace ripstop

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // line buffered, because rows take minutes
    const std::set<std::string> asked(argv + 1, argv + argc);
    const auto is_asked = [&](const char* name) { return asked.empty() || asked.contains(name); };
    if (is_asked("validation")) ripstop::print_validation();
    if (is_asked("shapes")) ripstop::print_shapes();
    if (is_asked("envelope")) ripstop::print_envelope();
}
