#include "ripstop/tile/seam_place.h"

#include <algorithm>

#include "ripstop/base/index.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

template <class Points>
auto point_on(const Points& positions, const Tile& tile, const BoundaryPlace& place) {
    const std::size_t i = static_cast<std::size_t>(place.edge), n = tile.boundary.size();
    using Point = Eigen::Matrix<double, Points::ColsAtCompileTime, 1>;
    const Point from = positions.row(tile.boundary[i]);
    const Point to = positions.row(tile.boundary[(i + 1) % n]);
    return Point(from + place.share * (to - from));
}

/// The fraction of an edge at which it is nearest to a point in space.
double share_nearest(const Tile& tile, int edge, const Vec3& point) {
    const Vec3 from = point_on(tile.mesh.positions, tile, {edge, 0});
    const Vec3 way = point_on(tile.mesh.positions, tile, {edge, 1}) - from;
    return std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
}

/// Whether the side's own data determine where it starts in its first edge: at a vertex, or so that it takes the rest
/// of that edge.
bool start_is_told(const SeamSide& side, const Eigen::VectorXd& drawn) {
    const SeamPart& part = side.parts.front();
    return side.parts.size() > 1 || part.length >= (1 - 1e-6) * drawn[part.edge];
}

/// The fraction of its edge at which the first part of a side starts.
double start_share(const std::vector<FlatTile>& tiles, const Seam& seam, bool second) {
    const SeamSide& side = second ? seam.b : seam.a;
    const Tile& tile = tiles[at(side.tile)].tile;
    const Eigen::VectorXd drawn = drawn_lengths(tile);
    const SeamPart& first = side.parts.front();
    const double share = first.length / drawn[first.edge];
    if (start_is_told(side, drawn)) return std::max(0.0, 1 - share);
    // A single part within an edge: the other side runs the opposite way, so its end is where this one starts.
    const SeamSide& other = second ? seam.a : seam.b;
    const Tile& mate = tiles[at(other.tile)].tile;
    const SeamPart& last = other.parts.back();
    const double reach = other.parts.size() > 1 ? last.length / drawn_lengths(mate)[last.edge] : 1;
    const Vec3 start = point_on(mate.mesh.positions, mate, {last.edge, std::min(1.0, reach)});
    return std::min(share_nearest(tile, first.edge, start), 1 - share);
}

}  // namespace

BoundaryPlace place_on_side(const std::vector<FlatTile>& tiles, const Seam& seam, bool second, double along) {
    const SeamSide& side = second ? seam.b : seam.a;
    const Eigen::VectorXd drawn = drawn_lengths(tiles[at(side.tile)].tile);
    double left = std::clamp(second ? seam.length - along : along, 0.0, seam.length);
    for (std::size_t i = 0; i < side.parts.size(); ++i) {
        const SeamPart& part = side.parts[i];
        if (left > part.length && i + 1 < side.parts.size()) {
            left -= part.length;
            continue;
        }
        const double from = i == 0 ? start_share(tiles, seam, second) : 0;
        return {part.edge, std::min(1.0, from + std::min(left, part.length) / drawn[part.edge])};
    }
    return {};
}

BoundaryPlace place_on_sheet(const std::vector<FlatTile>& tiles, const SeamSheet& sheet, double along) {
    const Seam& record = *sheet.record;
    const double own = !record.into ? along : sheet.backwards ? sheet.to - along : along - sheet.from;
    return place_on_side(tiles, record, sheet.side == &record.b, own);
}

Vec2 flat_point(const FlatTile& tile, const BoundaryPlace& place) {
    return point_on(tile.flattening.positions, tile.tile, place);
}

}  // namespace ripstop
