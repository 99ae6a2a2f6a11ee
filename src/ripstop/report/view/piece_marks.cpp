#include "ripstop/report/view/piece_marks.h"

#include <algorithm>
#include <limits>
#include <set>

#include "ripstop/mesh/boundary.h"

namespace ripstop {
namespace {

/// The point of the flat outline nearest to a point in space.
Vec2 nearest_on_outline(const FlatTile& tile, const Vec3& place) {
    const std::vector<int> loop = closed(tile.tile.boundary);
    double nearest = std::numeric_limits<double>::infinity();
    Vec2 found = Vec2::Zero();
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
        const Vec3 a = tile.tile.mesh.positions.row(loop[i]),
                   step = Vec3(tile.tile.mesh.positions.row(loop[i + 1])) - a;
        const double share = std::clamp(step.dot(place - a) / std::max(step.squaredNorm(), 1e-24), 0.0, 1.0);
        const double away = (place - a - share * step).norm();
        if (away >= nearest) continue;
        nearest = away;
        const Vec2 p = tile.flattening.positions.row(loop[i]), q = tile.flattening.positions.row(loop[i + 1]);
        found = p + share * (q - p);
    }
    return found;
}

}  // namespace

std::vector<FindingMark> finding_marks(const FlatTile& tile) {
    std::vector<FindingMark> marks;
    std::set<Eigen::Index> marked;
    for (std::size_t i = 0; i < tile.verdict.findings.size(); ++i) {
        const Vec3& at = tile.verdict.findings[i].at;
        if (!at.allFinite()) continue;
        Eigen::Index vertex = 0;
        (tile.tile.mesh.positions.rowwise() - at.transpose()).rowwise().squaredNorm().minCoeff(&vertex);
        if (marked.insert(vertex).second) marks.push_back({static_cast<int>(vertex), i});
    }
    return marks;
}

std::vector<Vec2> proposed_ends(const FlatTile& tile) {
    if (!tile.proposal || tile.proposal->line.size() < 2) return {};
    const std::vector<Vec3>& line = tile.proposal->line;
    return {nearest_on_outline(tile, line.front()), nearest_on_outline(tile, line.back())};
}

}  // namespace ripstop
