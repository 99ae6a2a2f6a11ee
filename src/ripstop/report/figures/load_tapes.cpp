#include "ripstop/report/figures/load_tapes.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

/// The mean of the ends of a seam's edges, as drawn.
Vec3 middle(const CutPlan& plan, const Seam& seam) {
    const Tile& tile = plan.tiles[at(seam.a.tile)].tile;
    Vec3 sum = Vec3::Zero();
    for (const SeamPart& part : seam.a.parts)
        for (const std::size_t k : {0u, 1u})
            sum += tile.mesh.positions.row(
                tile.boundary[(static_cast<std::size_t>(part.edge) + k) % tile.boundary.size()]);
    return sum / std::max(2.0 * static_cast<double>(seam.a.parts.size()), 1.0);
}

/// The centroid of the vertices of equal sectors lies on the axis.
Vec3 axis_of(const CutPlan& plan) {
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (const FlatTile& tile : plan.tiles) {
        sum += tile.tile.mesh.positions.colwise().sum().transpose();
        count += static_cast<double>(tile.tile.mesh.vertex_count());
    }
    return sum / std::max(count, 1.0);
}

/// The distance of two places after one is turned by the number of whole sectors that brings it closest.
double apart(const Vec3& a, const Vec3& b, int sectors) {
    const double sector = 2 * std::numbers::pi / sectors;
    const double between = std::atan2(a.y(), a.x()) - std::atan2(b.y(), b.x());
    const double turned = std::remainder(between, sector);
    const double near = a.head<2>().norm(), far = b.head<2>().norm();
    return std::hypot(near - far, 2 * std::sqrt(near * far) * std::sin(turned / 2), a.z() - b.z());
}

}  // namespace

std::vector<int> tapes_of_seams(const CutPlan& plan) {
    constexpr double nearest =
        0.05;  // of the seam's length; equal seams may be divided differently, other seams are farther off
    const std::vector<InflatedTape>& tapes = plan.inflated->tapes;
    std::vector<int> found(plan.seams.size(), -1);
    for (std::size_t t = 0; t < tapes.size(); ++t)
        if (tapes[t].kind == TapeKind::load) found[static_cast<std::size_t>(tapes[t].source)] = static_cast<int>(t);
    if (plan.inflated->sectors == 1) return found;
    const Vec3 axis = axis_of(plan);
    const std::vector<int> own = found;
    for (std::size_t s = 0; s < plan.seams.size(); ++s) {
        if (own[s] >= 0 || !plan.seams[s].has_tape()) continue;
        const Vec3 at = middle(plan, plan.seams[s]) - axis;
        double least = nearest * plan.seams[s].length;
        for (std::size_t other = 0; other < plan.seams.size(); ++other) {
            if (own[other] < 0) continue;
            const double away = apart(at, middle(plan, plan.seams[other]) - axis, plan.inflated->sectors);
            if (away >= least) continue;
            least = away;
            found[s] = own[other];
        }
    }
    return found;
}

std::vector<double> tape_cut_lengths(const CutPlan& plan) {
    std::vector<double> lengths(plan.seams.size(), std::numeric_limits<double>::quiet_NaN());
    if (!plan.inflated && plan.tape_factors.empty()) return lengths;
    const auto unshortened = [&](std::size_t s) {
        return plan.seams[s].length * (plan.tape_factors.empty() ? 1 : plan.tape_factors[s]);
    };
    double shortening = 1;
    if (plan.inflated)
        for (const InflatedTape& tape : plan.inflated->tapes)
            if (tape.kind == TapeKind::load)
                shortening = tape.cut_length / unshortened(static_cast<std::size_t>(tape.source));
    for (std::size_t s = 0; s < plan.seams.size(); ++s)
        if (plan.seams[s].has_tape()) lengths[s] = shortening * unshortened(s);
    return lengths;
}

}  // namespace ripstop
