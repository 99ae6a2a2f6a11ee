#include "ripstop/report/view/first_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/report/view/envelope_view.h"

namespace ripstop {
namespace {

constexpr double equal_share = 1e-6;  ///< relative to the largest score: equal tiles differ by rounding

/// The largest ratio of a tile's findings to their limits; 0 if the tile can be made.
double excess(const FlatTile& tile) {
    if (tile.verdict.manufacturable()) return 0;
    double worst = std::numeric_limits<double>::min();  // a tile without a verdict precedes those that pass
    for (const Finding& finding : tile.verdict.findings)
        worst = std::max(worst, std::abs(finding.value / (finding.limit != 0 ? finding.limit : 1)));
    return worst;
}

double drift(const CutPlan& plan, int tile) {
    double worst = 0;
    for (std::size_t i = 0; i < plan.walks.size(); ++i)
        if (!plan.walks[i].ok && plan.seams[i].a.tile == tile)
            worst = std::max(worst, plan.walks[i].drift_max / plan.walks[i].limit);
    return worst;
}

double largest(const Eigen::VectorXd& values) {
    double size = 0;
    for (const double value : values)
        if (std::isfinite(value)) size = std::max(size, std::abs(value));
    return size;
}

double largest_share(const MapView& view, std::size_t tile) {
    const MapScale& scale = view.scales.front();
    const double edges = view.edges.empty() ? 0 : largest(view.edges[tile]) / scale.edges;
    return scale.cloth.empty() ? edges : std::max(edges, largest(view.cloth[tile]) / scale.cloth[tile]);
}

/// The scores by the first criterion that any tile meets.
std::vector<double> scores(const CutPlan& plan, const MapView& view) {
    std::vector<double> result(plan.tiles.size(), 0);
    const auto is_scored = [&](const auto& score) {
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = score(i);
        return std::any_of(result.begin(), result.end(), [](double value) { return value > 0; });
    };
    if (is_scored([&](std::size_t i) { return excess(plan.tiles[i]); })) return result;
    if (is_scored([&](std::size_t i) { return drift(plan, static_cast<int>(i)); })) return result;
    is_scored([&](std::size_t i) { return largest_share(view, i); });
    return result;
}

/// The fraction of a tile's area that faces the viewer, minus the fraction that faces away.
double facing(const Points3& positions, const Triangles& triangles) {
    Vec3 normal = Vec3::Zero();
    double area = 0;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
        const Vec3 a = positions.row(triangles(t, 0)), b = positions.row(triangles(t, 1)),
                   c = positions.row(triangles(t, 2));
        const Vec3 one = (b - a).cross(c - a);
        normal += one;
        area += one.norm();
    }
    return area > 0 ? normal.dot(home_direction.normalized()) / area : 0;
}

}  // namespace

int first_tile(const CutPlan& plan, const MapView& view) {
    const std::vector<double> score = scores(plan, view);
    if (score.empty()) return -1;
    const double most = *std::max_element(score.begin(), score.end());
    const EnvelopeShape shape = envelope_shape(plan);
    int found = static_cast<int>(std::max_element(score.begin(), score.end()) - score.begin());
    double nearest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < score.size(); ++i) {
        if (score[i] < (1 - equal_share) * most) continue;
        const double turned = facing(shape.positions[i], plan.tiles[i].tile.mesh.triangles);
        if (turned <= nearest) continue;
        nearest = turned;
        found = static_cast<int>(i);
    }
    return found;
}

}  // namespace ripstop
