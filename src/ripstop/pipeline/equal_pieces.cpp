#include "ripstop/pipeline/equal_pieces.h"

#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

/// What turns the first piece into the other: x and y with these signs.
Eigen::RowVector2d signs(const Likeness& likeness) {
    const double half_turn = likeness.grain_reversed ? -1 : 1;
    return {half_turn, likeness.mirrored ? -half_turn : half_turn};
}

/// The piece's outline about its middle, so that where it lies on the page does not matter.
Points2 centred_outline(const FlatTile& tile) {
    const Points2 outline = tile.flattening.positions(tile.tile.boundary, Eigen::all);
    const Vec2 start = outline.row(0);
    Vec2 middle = Vec2::Zero();
    double area = 0;
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Vec2 a = Vec2(outline.row(i)) - start;
        const Vec2 b = Vec2(outline.row((i + 1) % outline.rows())) - start;
        const double twice = a.x() * b.y() - a.y() * b.x();
        middle += twice * (a + b) / 3;
        area += twice;
    }
    return outline.rowwise() - (start + middle / area).transpose();
}

bool within(const Points2& points, const Points2& outline, double tolerance) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        if (!(distance_to_outline(outline, points.row(i)) <= tolerance)) return false;
    return true;
}

bool cut_alike(const FlatTile& first, const FlatTile& other, const Likeness& likeness, double tolerance) {
    for (const FlatTile* tile : {&first, &other})
        if (tile->flattening.positions.rows() != tile->tile.mesh.vertex_count() ||
            !tile->flattening.positions.allFinite())
            return false;
    const Points2 a = centred_outline(first) * signs(likeness).asDiagonal(), b = centred_outline(other);
    return within(a, b, tolerance) && within(b, a, tolerance);
}

}  // namespace

Flattening copied_flattening(const FlatTile& first, const Tile& tile, const Likeness& likeness) {
    Flattening flat = first.flattening;
    if (flat.positions.rows() == first.tile.mesh.vertex_count())
        flat.positions = first.flattening.positions(likeness.vertex, Eigen::all) * signs(likeness).asDiagonal();
    if (flat.seam_tension.size() == 0) return flat;
    std::vector<Eigen::Index> place(static_cast<std::size_t>(first.tile.mesh.vertex_count()));
    for (std::size_t i = 0; i < first.tile.boundary.size(); ++i)
        place[static_cast<std::size_t>(first.tile.boundary[i])] = static_cast<Eigen::Index>(i);
    const auto there = [&](std::size_t i) {
        const int vertex = tile.boundary[i % tile.boundary.size()];
        return place[static_cast<std::size_t>(likeness.vertex[static_cast<std::size_t>(vertex)])];
    };
    // A mirror image is walked the other way round: an edge begins there where it ends here.
    for (std::size_t i = 0; i < tile.boundary.size(); ++i)
        flat.seam_tension[static_cast<Eigen::Index>(i)] =
            first.flattening.seam_tension[there(likeness.mirrored ? i + 1 : i)];
    return flat;
}

Bounds moved_bounds(Bounds bounds, const Likeness& likeness) {
    if (likeness.mirrored) bounds.centre.x() *= -1;
    bounds.centre = likeness.motion * bounds.centre;
    return bounds;
}

void list_equal_pieces(CutPlan& plan, const std::vector<Likeness>& likeness, double tolerance) {
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        if (likeness[i].to < 0) continue;
        const FlatTile& first = plan.tiles[static_cast<std::size_t>(likeness[i].to)];
        if (!cut_alike(first, plan.tiles[i], likeness[i], tolerance)) continue;
        plan.tiles[i].equal_to = likeness[i].to;
        plan.tiles[i].mirrored = likeness[i].mirrored;
    }
}

}  // namespace ripstop
