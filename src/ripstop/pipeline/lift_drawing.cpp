#include "ripstop/pipeline/lift_drawing.h"

#include <algorithm>
#include <cmath>

#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/lift_lines.h"

namespace ripstop {
namespace {

constexpr double same_size = 0.1e-3;  // of an outline that was written with few decimals and read again [m]
constexpr double same_place = 0.05e-3;

struct Extent {
    Vec2 lower, upper;

    explicit Extent(const Points2& points)
        : lower(points.colwise().minCoeff().transpose()), upper(points.colwise().maxCoeff().transpose()) {}
    bool is_apart_from(const Extent& other) const {
        return (lower - other.upper).maxCoeff() > 0 || (other.lower - upper).maxCoeff() > 0;
    }
};

/// A path of the drawing in metres; a closed one as a ring that ends where it starts.
Points2 in_metres(const DrawnPath& path, double metres_per_unit) {
    Points2 points(path.points.rows() + (path.is_closed ? 1 : 0), 2);
    points.topRows(path.points.rows()) = path.points * metres_per_unit;
    if (path.is_closed) points.bottomRows(1) = points.topRows(1);
    return points;
}

bool is_outline(const Points2& ring, const Points2& outline) {
    if (ring.rows() < 4 || (ring.row(0) - ring.row(ring.rows() - 1)).norm() > same_size) return false;
    const Extent there(ring), here(outline);
    if (((there.upper - there.lower) - (here.upper - here.lower)).cwiseAbs().maxCoeff() > same_size) return false;
    const Points2 corners = ring.topRows(ring.rows() - 1);
    return std::abs(std::abs(signed_area(corners)) - signed_area(outline)) < same_size * perimeter(outline);
}

/// Is each point of the line on the piece's own sew line or grain arrow?
bool is_own(const Points2& line, const PatternPiece& piece) {
    const auto lies = [&](const Points2& on) {
        for (Eigen::Index i = 0; i < line.rows(); ++i)
            if (distance_to_outline(on, line.row(i)) > same_place) return false;
        return true;
    };
    if (lies(piece.sew_line)) return true;
    if (piece.grain_line.rows() != 2) return false;
    const Vec2 head = piece.grain_line.row(1);
    const double barb = 1.2 * arrow_head((head - Vec2(piece.grain_line.row(0))).norm());
    const bool is_barb = (line.rowwise() - head.transpose()).rowwise().norm().maxCoeff() < barb;
    return is_barb || lies(piece.grain_line);
}

}  // namespace

LiftedLines lift_drawing(const PatternDrawing& drawing, double metres_per_unit, const PieceSet& set,
                         const std::function<NamedMesh(const PatternPiece&)>& tile) {
    std::vector<Points2> lines;
    for (const DrawnPath& path : drawing.paths) lines.push_back(in_metres(path, metres_per_unit));
    std::vector<bool> is_taken(lines.size(), false);

    LiftedLines lifted;
    for (const PatternPiece& piece : set.pieces) {
        std::size_t ring = 0;
        while (ring < lines.size() && (is_taken[ring] || !is_outline(lines[ring], piece.outline()))) ++ring;
        if (ring == lines.size()) continue;
        is_taken[ring] = true;
        ++lifted.pieces;
        const Vec2 shift = piece.lower() - Extent(lines[ring]).lower;
        NamedMesh surface;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (i == ring || lines[i].rows() < 2 || Extent(lines[i]).is_apart_from(Extent(lines[ring]))) continue;
            const Points2 line = lines[i].rowwise() + shift.transpose();
            if (is_own(line, piece)) continue;
            if (surface.mesh.triangle_count() == 0) surface = tile(piece);
            for (Points3& part : lift_line(surface.mesh, surface.drawn.value(), line)) {
                const std::string& layer = drawing.paths[i].layer;
                lifted.curves.push_back({(layer.empty() ? "line" : layer) + " " + piece.name,
                                         std::move(part),
                                         {{"layer", layer}, {"tile", piece.name}}});
            }
        }
    }
    return lifted;
}

}  // namespace ripstop
