#include "ripstop/pattern/pieces.h"

#include <algorithm>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/annotation.h"

namespace ripstop {
namespace {

Points2 sew_line(const FlatTile& tile) {
    const std::vector<int>& loop = tile.tile.boundary;
    Points2 outline(static_cast<Eigen::Index>(loop.size()), 2);
    for (std::size_t i = 0; i < loop.size(); ++i)
        outline.row(static_cast<Eigen::Index>(i)) = tile.flattening.positions.row(loop[i]);
    if (signed_area(outline) < 0) outline = outline.colwise().reverse().eval();
    return outline;
}

/// Across the pole, within the circle and six tenths of the width: where nothing better is to be had.
Points2 grain_line_at_pole(const Points2& outline, const Circle& room) {
    double half = 0.5 * room.radius;
    for (const auto& chord : horizontal_chords(outline, room.centre.y()))
        if (chord[0] <= room.centre.x() && room.centre.x() <= chord[1])
            half = std::min({half, 0.3 * (chord[1] - chord[0])});
    Points2 line(2, 2);
    line << room.centre.x() - half, room.centre.y(), room.centre.x() + half, room.centre.y();
    return line;
}

}  // namespace

bool has_flat_positions(const FlatTile& tile) {
    const Points2& positions = tile.flattening.positions;
    return positions.rows() == tile.tile.mesh.vertex_count() && positions.rows() > 0 && positions.allFinite();
}

PatternPiece make_piece(const FlatTile& tile) {
    if (!has_flat_positions(tile))
        throw InputError("tile " + tile.tile.name + ": has no flat positions (" + tile.flattening.summary.text() +
                         "), so there is no piece to draw; flatten it first");
    PatternPiece piece;
    piece.name = tile.tile.name;
    piece.sew_line = sew_line(tile);
    // The radius is at least area over perimeter, so this is a tenth of it or better; the floor is for outlines without
    // inside, which failed flattenings have.
    const double precision = std::max(1e-4 * (piece.upper() - piece.lower()).maxCoeff(),
                                      0.1 * signed_area(piece.sew_line) / perimeter(piece.sew_line));
    const Circle room = largest_circle_inside(piece.sew_line, precision);
    // Two fifths of the circle's radius leave room for the arrow above or below; less if that was not enough.
    double largest = std::clamp(0.4 * room.radius, 0.003, 0.040);
    for (int attempt = 0; attempt < 3; ++attempt, largest /= 2) {
        const LabelPlace label = place_label(piece.sew_line, room, piece.name, largest);
        piece.labels = label.labels;
        piece.grain_line = place_grain_line(piece.sew_line, room, label.box);
        if (piece.grain_line.rows() == 2 && piece.grain_line(1, 0) - piece.grain_line(0, 0) >= 0.5 * room.radius)
            return piece;
    }
    if (piece.grain_line.rows() != 2) piece.grain_line = grain_line_at_pole(piece.sew_line, room);
    return piece;
}

std::vector<PatternPiece> make_pieces(const CutPlan& plan) {
    std::vector<PatternPiece> pieces;
    for (const FlatTile& tile : plan.tiles)
        if (has_flat_positions(tile)) pieces.push_back(make_piece(tile));
    return pieces;
}

std::vector<Vec2> lay_out(const std::vector<PatternPiece>& pieces, double gap) {
    double total = 0, widest = 0;
    for (const PatternPiece& piece : pieces) {
        if (piece.sew_line.rows() == 0) continue;
        const Vec2 size = piece.upper() - piece.lower();
        total += (size.x() + gap) * (size.y() + gap);
        widest = std::max(widest, size.x());
    }
    // Rows do not fill up: a tenth more than the square root comes out about square.
    const double sheet_width = std::max(widest, 1.1 * std::sqrt(total));
    std::vector<Vec2> shifts(pieces.size(), Vec2::Zero());
    double x = 0, top = 0, row_height = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].sew_line.rows() == 0) continue;
        const Vec2 lower = pieces[i].lower(), upper = pieces[i].upper();
        if (x > 0 && x + (upper - lower).x() > sheet_width) {
            top -= row_height + gap;
            x = row_height = 0;
        }
        shifts[i] = Vec2(x - lower.x(), top - upper.y());
        x += (upper - lower).x() + gap;
        row_height = std::max(row_height, (upper - lower).y());
    }
    const double bottom = top - row_height;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (pieces[i].sew_line.rows() > 0) shifts[i].y() -= bottom;
    return shifts;
}

}  // namespace ripstop
