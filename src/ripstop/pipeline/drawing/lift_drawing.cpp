#include "ripstop/pipeline/drawing/lift_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ripstop/geometry/clip.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/text/sheet.h"
#include "ripstop/pattern/drawing/lift_lines.h"
#include "ripstop/pipeline/drawing/drawn_pieces.h"

namespace ripstop {
namespace {

constexpr double same_point = 0.05e-3;
constexpr double lift_step = 2e-3;  // distance between sampled points of a line [m]
constexpr int most_steps = 2000;
constexpr double longest_mark = 10e-3;  // match marks are 3 mm long where nothing can be cut [m]

/// A path of the drawing in metres; a closed path as a ring that ends where it starts.
Points2 in_metres(const DrawnPath& path, double metres_per_unit) {
    Points2 points(path.points.rows() + (path.is_closed ? 1 : 0), 2);
    points.topRows(path.points.rows()) = path.points * metres_per_unit;
    if (path.is_closed) points.bottomRows(1) = points.topRows(1);
    return points;
}

/// A line of the drawing with its bounding box [m].
struct Line {
    const DrawnPath* path;
    Points2 points;
    Vec2 lower, upper;

    Line(const DrawnPath& drawn, double metres_per_unit)
        : path(&drawn),
          points(in_metres(drawn, metres_per_unit)),
          lower(points.colwise().minCoeff()),
          upper(points.colwise().maxCoeff()) {}
    bool is_apart_from(const DrawnPiece& piece) const {
        return (lower - piece.upper).maxCoeff() > 0 || (piece.lower - upper).maxCoeff() > 0;
    }
    bool is_outline_of(const DrawnPiece& piece) const {
        return std::find(piece.outline.begin(), piece.outline.end(), path) != piece.outline.end();
    }
};

/// Samples the whole line: a straight line across the piece has both ends on the outline.
bool lies_on(const Points2& outline, const Points2& line) {
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
        const Vec2 from = line.row(i), to = line.row(i + 1);
        const int steps = std::clamp(static_cast<int>(std::ceil((to - from).norm() / lift_step)), 2, most_steps);
        for (int k = 0; k <= steps; ++k)
            if (distance_to_outline(outline, from + (static_cast<double>(k) / steps) * (to - from)) > same_point)
                return false;
    }
    return true;
}

bool is_match_mark(const Points2& line, const PatternPiece& piece) {
    const Vec2 start = line.row(0), end = line.row(line.rows() - 1);
    const double length = (end - start).norm();
    if (line.rows() != 2 || length > longest_mark) return false;
    const auto meets = [&](const Vec2& a, const Vec2& b) {
        return std::max((a - start).norm(), (b - end).norm()) <= same_point;
    };
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.strokes(notch.on_sew, length))
            if (notch.depth <= 0 && (meets(from, to) || meets(to, from))) return true;
    return false;
}

bool is_own(const Points2& line, const PatternPiece& piece) {
    if (lies_on(piece.sew_line, line) || is_match_mark(line, piece)) return true;
    const Points2 arrow = grain_arrow(piece);
    if (arrow.rows() != 4) return false;
    Points2 head(3, 2);
    head << arrow.row(2), arrow.row(1), arrow.row(3);
    return lies_on(arrow.topRows(2), line) || lies_on(head, line);
}

}  // namespace

LiftedLines lift_drawing(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                         const std::function<NamedMesh(const PatternPiece&)>& tile, const std::string& stem) {
    std::vector<Line> lines;
    for (const DrawnPath& path : drawing.paths)
        if (path.points.rows() > 1) lines.emplace_back(path, metres_per_unit);
    DrawnPieces drawn = find_drawn_pieces(drawing, metres_per_unit, set, stem);

    LiftedLines lifted{{}, static_cast<int>(drawn.found.size()), std::move(drawn.strangers)};
    for (const DrawnPiece& found : drawn.found) {
        const PatternPiece& piece = *found.piece;
        NamedMesh surface;
        for (const Line& line : lines) {
            if (line.is_apart_from(found) || line.is_outline_of(found)) continue;
            const Points2 points = line.points.rowwise() + found.shift().transpose();
            if (is_own(points, piece)) continue;
            if (surface.mesh.triangle_count() == 0) surface = tile(piece);
            const std::string& layer = line.path->layer;
            for (Points3& part : lift_line(surface.mesh, surface.drawn.value(), points))
                lifted.curves.push_back({(layer.empty() ? "line" : layer) + " " + piece.name,
                                         std::move(part),
                                         {{"layer", layer}, {"tile", piece.name}}});
        }
    }
    return lifted;
}

}  // namespace ripstop
