#include "ripstop/measure/judge.h"

#include <cmath>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

std::string percent_text(double ratio) {
    return format_fixed(std::abs(ratio) / percent, 3) + " %";
}

/// The middle vertex of the chain.
Vec3 middle_of(const Tile& tile, const Chain& chain) {
    return tile.mesh.positions.row(chain.vertices[chain.vertices.size() / 2]);
}

constexpr double plotter_step = 0.025 * millimetre;  // of HP-GL: no cutter makes an edge more accurate than this,
                                                     // however short it is
constexpr double certified_length = 1e-8;
constexpr double certified_force = 1e-6;  // relative to mean stiffness times mean boundary edge

void judge_bounds(const Bounds& bounds, const Tolerances& tolerances, Verdict& verdict) {
    const double least = (1 - tolerances.area) / ((1 + tolerances.length) * (1 + tolerances.length));
    if (bounds.isoperimetric < least)
        verdict.findings.push_back({"isoperimetric",
                                    "no outline of this length encloses this much area: L^2 / (4 pi A) is " +
                                        format_fixed(bounds.isoperimetric, 4) + ", a flat piece has at least " +
                                        format_fixed(least, 4),
                                    bounds.centre, bounds.isoperimetric, least});
    const double allowed = allowed_stretch_ratio(tolerances);
    if (bounds.stretch_ratio > allowed)
        verdict.findings.push_back({"stretch_bound",
                                    "the disc of " + format_fixed(bounds.radius / millimetre, 0) +
                                        " mm about here stretches by a ratio of at least " +
                                        format_fixed(bounds.stretch_ratio, 4) +
                                        " in any flattening, the cloth allows " + format_fixed(allowed, 4),
                                    bounds.centre, bounds.stretch_ratio, allowed});
}

void judge_certificate(const Tile& tile, const Flattening& flattening, Verdict& verdict) {
    if (!flattening.certificate || !flattening.summary.usable()) return;
    const Certificate& shown = *flattening.certificate;
    const Vec3 centre = centroid(tile.mesh);
    if (!(shown.length_residual <= certified_length))
        verdict.findings.push_back({"uncertified", "the edges are not exact to 1e-8 of their length", centre,
                                    shown.length_residual, certified_length});
    if (!(shown.force_residual <= certified_force))
        verdict.findings.push_back({"uncertified", "the forces in the cloth are not in balance", centre,
                                    shown.force_residual, certified_force});
    if (!shown.strict_minimum)
        verdict.findings.push_back(
            {"uncertified", "the result is not proven to be a strict minimum of the cloth's energy", centre, 0, 1});
}

void judge_map(const SolveSummary& summary, const Accuracy& accuracy, Verdict& verdict, const Tile& tile) {
    const Vec3 centre = centroid(tile.mesh);
    if (!summary.usable())
        verdict.findings.push_back({"unsolved", "no flattening was found: " + summary.reason, centre, 1, 0});
    else if (summary.termination == Termination::iteration_limit)
        verdict.findings.push_back({"unsolved", "the flattening is not at rest: " + summary.reason, centre, 1, 0});
    if (accuracy.flipped > 0)
        verdict.findings.push_back({"flipped",
                                    std::to_string(accuracy.flipped) + " of the triangles are flipped on the cloth",
                                    accuracy.worst_flip, static_cast<double>(accuracy.flipped), 0});
    if (accuracy.outline_crossings > 0 && accuracy.overlaps == 0)
        verdict.findings.push_back({"outline", "the outline of the piece meets itself on the cloth", centre,
                                    static_cast<double>(accuracy.outline_crossings), 0});
    if (accuracy.overlaps > 0)
        verdict.findings.push_back({"overlap", "the piece overlaps itself on the cloth", accuracy.worst_overlap,
                                    static_cast<double>(accuracy.overlaps), 0});
}

void judge_lengths(const Tile& tile, const Accuracy& accuracy, const Tolerances& tolerances, Verdict& verdict) {
    if (!(std::abs(accuracy.area_error) <= tolerances.area))
        verdict.findings.push_back({"area",
                                    "the piece has " + percent_text(accuracy.area_error) + " too " +
                                        (accuracy.area_error > 0 ? "much" : "little") + " area",
                                    centroid(tile.mesh), accuracy.area_error / percent, tolerances.area / percent});
    if (!(std::abs(accuracy.perimeter_error) <= tolerances.length))
        verdict.findings.push_back({"perimeter",
                                    "the outline is " + percent_text(accuracy.perimeter_error) +
                                        (accuracy.perimeter_error > 0 ? " longer" : " shorter") + " than drawn",
                                    accuracy.worst_edge, accuracy.perimeter_error / percent,
                                    tolerances.length / percent});
    for (std::size_t i = 0; i < accuracy.chains.size(); ++i) {
        const ChainAccuracy& chain = accuracy.chains[i];
        if (std::abs(chain.error()) <= tolerances.length || std::abs(chain.flat_length - chain.length) <= plotter_step)
            continue;
        verdict.findings.push_back({"chain",
                                    "edge " + std::to_string(i + 1) + " is " + percent_text(chain.error()) + " (" +
                                        format_fixed(std::abs(chain.flat_length - chain.length) / millimetre, 1) +
                                        " mm) " + (chain.error() > 0 ? "longer" : "shorter") + " than drawn",
                                    middle_of(tile, tile.chains[i]), chain.error() / percent,
                                    tolerances.length / percent, static_cast<int>(i)});
    }
}

void judge_strain(const Accuracy& accuracy, const Tolerances& tolerances, Verdict& verdict) {
    const auto strain = [&](const char* code, const char* direction, double low, double high, const Vec3& at) {
        const double worst = -low > high ? low : high;
        if (std::abs(worst) <= tolerances.strain) return;
        verdict.findings.push_back({code,
                                    std::string("the cloth must ") + (worst > 0 ? "stretch by " : "shrink by ") +
                                        percent_text(worst) + " along the " + direction,
                                    at, worst / percent, tolerances.strain / percent});
    };
    strain("warp_strain", "warp", accuracy.warp_strain_min, accuracy.warp_strain_max, accuracy.worst_warp);
    strain("weft_strain", "weft", accuracy.weft_strain_min, accuracy.weft_strain_max, accuracy.worst_weft);
    if (!(accuracy.shear_max <= tolerances.shear))
        verdict.findings.push_back(
            {"shear", "the threads must shear by " + format_fixed(accuracy.shear_max / degree, 2) + " degrees",
             accuracy.worst_shear, accuracy.shear_max / degree, tolerances.shear / degree});
}

}  // namespace

Tolerances tolerances_of(const Fabric& fabric) {
    Tolerances tolerances;
    tolerances.strain = fabric.strain_limit;
    tolerances.shear = fabric.shear_limit;
    return tolerances;
}

Verdict judge(const Tile& tile, const Bounds& bounds, const Flattening& flattening, const Accuracy& accuracy,
              const Tolerances& tolerances) {
    Verdict verdict;
    verdict.judged = true;
    judge_bounds(bounds, tolerances, verdict);
    judge_map(flattening.summary, accuracy, verdict, tile);
    judge_certificate(tile, flattening, verdict);
    judge_lengths(tile, accuracy, tolerances, verdict);
    judge_strain(accuracy, tolerances, verdict);
    return verdict;
}

}  // namespace ripstop
