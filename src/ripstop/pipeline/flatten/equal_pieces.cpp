#include "ripstop/pipeline/flatten/equal_pieces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "ripstop/base/index.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/drawn_lines.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pattern/piece/seam_match.h"
#include "ripstop/tile/allowance.h"

namespace ripstop {
namespace {

/// The signs of x and y that map the first piece to the other one.
Eigen::RowVector2d signs(const Likeness& likeness) {
    const double half_turn = likeness.grain_reversed ? -1 : 1;
    return {half_turn, likeness.mirrored ? -half_turn : half_turn};
}

/// The outline relative to its centroid, so its position on the page does not matter.
Points2 centred_outline(const FlatTile& tile) {
    const Points2 outline = tile.flattening.positions(tile.tile.boundary, Eigen::all);
    return outline.rowwise() - area_centroid(outline).transpose();
}

bool within(const Points2& points, const Points2& outline, double tolerance) {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        if (!(distance_to_outline(outline, points.row(i)) <= tolerance)) return false;
    return true;
}

/// The edge of an outline nearest to a point.
Eigen::Index nearest_edge(const Points2& outline, const Vec2& point) {
    Eigen::Index nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Vec2 start = outline.row(i), along = Vec2(outline.row((i + 1) % outline.rows())) - start;
        const double length = std::max(along.squaredNorm(), std::numeric_limits<double>::min());
        const double away = (start + std::clamp(along.dot(point - start) / length, 0.0, 1.0) * along - point).norm();
        if (away < least) {
            least = away;
            nearest = i;
        }
    }
    return nearest;
}

/// Whether both have the same allowance everywhere, tested at the middle of each edge of `a`.
bool same_allowances(const Points2& a, const Points2& b, const Eigen::VectorXd& of_a, const Eigen::VectorXd& of_b) {
    if (of_a.minCoeff() == of_a.maxCoeff() && of_b.minCoeff() == of_b.maxCoeff()) return of_a[0] == of_b[0];
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        const Vec2 middle = (a.row(i) + a.row((i + 1) % a.rows())) / 2;
        if (of_a[i] != of_b[nearest_edge(b, middle)]) return false;
    }
    return true;
}

/// The lines drawn on a piece, relative to the centroid of its outline.
std::vector<DrawnLine> centred_lines(const FlatTile& tile) {
    constexpr double exactly = 1e-9;
    if (tile.tile.lines.empty() || !tile.is_flat()) return {};
    std::vector<DrawnLine> lines = draw_lines(tile, exactly);
    const Vec2 middle = area_centroid(tile.flattening.positions(tile.tile.boundary, Eigen::all));
    for (DrawnLine& line : lines) line.points.rowwise() -= middle.transpose();
    return lines;
}

/// Whether each line of `a` has a line of the same name at the same place in `b`.
bool has_lines(const std::vector<DrawnLine>& a, const std::vector<DrawnLine>& b, const Eigen::RowVector2d& signs) {
    constexpr double same_place = 0.5e-3;  // [m]
    return std::all_of(a.begin(), a.end(), [&](const DrawnLine& line) {
        const Points2 points = line.points * signs.asDiagonal();
        return std::any_of(b.begin(), b.end(), [&](const DrawnLine& other) {
            return other.name == line.name && within(points, other.points, same_place) &&
                   within(other.points, points, same_place);
        });
    });
}

/// Compares colours, outlines and allowances of two tiles; the second is the first with these signs.
bool cut_alike(const std::array<const FlatTile*, 2>& tiles, const std::array<const Eigen::VectorXd*, 2>& allowances,
               const Eigen::RowVector2d& signs, double tolerance) {
    if (colour_of(tiles[0]->tile) != colour_of(tiles[1]->tile)) return false;
    for (const FlatTile* tile : tiles)
        if (!tile->is_flat()) return false;
    const Points2 a = centred_outline(*tiles[0]) * signs.asDiagonal(), b = centred_outline(*tiles[1]);
    return within(a, b, tolerance) && within(b, a, tolerance) && same_allowances(a, b, *allowances[0], *allowances[1]);
}

}  // namespace

Flattening copied_flattening(const FlatTile& first, const Tile& tile, const Likeness& likeness) {
    Flattening flat = first.flattening;
    if (flat.positions.rows() == first.tile.mesh.vertex_count())
        flat.positions = first.flattening.positions(likeness.vertex, Eigen::all) * signs(likeness).asDiagonal();
    if (flat.seam_tension.size() == 0) return flat;
    std::vector<Eigen::Index> place(static_cast<std::size_t>(first.tile.mesh.vertex_count()));
    for (std::size_t i = 0; i < first.tile.boundary.size(); ++i)
        place[at(first.tile.boundary[i])] = static_cast<Eigen::Index>(i);
    const auto there = [&](std::size_t i) {
        const int vertex = tile.boundary[i % tile.boundary.size()];
        return place[at(likeness.vertex[at(vertex)])];
    };
    // The boundary of a mirror image runs the other way, so its edges start where these end.
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
    const std::vector<Eigen::VectorXd> allowances = edge_allowances(plan);
    const SeamEnds ends(plan);
    std::vector<std::vector<DrawnLine>> lines;
    for (const FlatTile& tile : plan.tiles) lines.push_back(centred_lines(tile));
    // for each kind of tile, those whose patterns differ
    std::map<std::size_t, std::vector<std::size_t>> patterns;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const std::size_t kind = likeness[i].to < 0 ? i : static_cast<std::size_t>(likeness[i].to);
        std::vector<std::size_t>& known = patterns[kind];
        const auto pattern = std::find_if(known.begin(), known.end(), [&](std::size_t first) {
            // both derive from the first of their kind by signs, so the product of the signs maps one to the other
            const Eigen::RowVector2d between = signs(likeness[first]).cwiseProduct(signs(likeness[i]));
            return cut_alike({&plan.tiles[first], &plan.tiles[i]}, {&allowances[first], &allowances[i]}, between,
                             tolerance) &&
                   lines[first].size() == lines[i].size() && has_lines(lines[first], lines[i], between) &&
                   has_lines(lines[i], lines[first], between) &&
                   ends.match(i, first, likeness[first].mirrored != likeness[i].mirrored);
        });
        if (pattern == known.end()) {
            known.push_back(i);
            continue;
        }
        plan.tiles[i].equal_to = static_cast<int>(*pattern);
        plan.tiles[i].mirrored = likeness[*pattern].mirrored != likeness[i].mirrored;
    }
}

}  // namespace ripstop
