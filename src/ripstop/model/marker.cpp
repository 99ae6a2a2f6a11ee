#include "ripstop/model/marker.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

Points2 reversed(const Points2& points) {
    return points.colwise().reverse();
}

/// Drawn mirrored, a line runs clockwise: backwards from its first edge's start, so that edges follow one another again.
void run_backwards(PatternPiece& piece) {
    const auto points = static_cast<int>(piece.sew_line.rows());
    const int start = piece.edges.empty() ? 0 : piece.edges.front().first;
    const Points2 line = piece.sew_line;
    for (int i = 0; i < points; ++i) piece.sew_line.row(i) = line.row((start - i + points) % points);
    piece.cut_line = reversed(piece.cut_line);
    const std::vector<PieceEdge> edges = piece.edges;
    const std::size_t count = edges.size();
    for (std::size_t e = 0; e < count; ++e) {
        const std::size_t old = count - 1 - e;
        piece.edges[e] = edges[old];
        std::reverse(piece.edges[e].mates.begin(), piece.edges[e].mates.end());
        piece.edges[e].first = e == 0 ? 0 : (start - edges[old + 1].first + points) % points;
    }
    for (PieceNotch& notch : piece.notches) notch.edge = static_cast<int>(count) - 1 - notch.edge;
}

/// Within a quarter turn of upright, whatever way the piece lies.
double upright(double turn) {
    turn = std::remainder(turn, 2 * std::numbers::pi);
    constexpr double quarter = std::numbers::pi / 2 + 1e-9;
    if (turn > quarter) turn -= std::numbers::pi;
    if (turn < -quarter) turn += std::numbers::pi;
    return turn;
}

}  // namespace

Points2 Placement::placed(const Points2& points) const {
    const double cosine = std::cos(turn), sine = std::sin(turn), sign = is_drawn_mirrored() ? -1 : 1;
    Points2 result(points.rows(), 2);
    result.col(0) = cosine * points.col(0) - sign * sine * points.col(1);
    result.col(1) = sine * points.col(0) + sign * cosine * points.col(1);
    result.rowwise() += shift.transpose();
    return result;
}

PatternPiece placed_piece(const PatternPiece& piece, const Placement& placement) {
    const auto at = [&placement](const Vec2& p) -> Vec2 {
        return placement.placed(Points2(p.transpose())).row(0).transpose();
    };
    const Vec2 origin = at(Vec2::Zero());
    PatternPiece laid = piece;
    laid.name += placement.mirrored ? " mirrored" : "";
    laid.sew_line = placement.placed(piece.sew_line);
    laid.cut_line = placement.placed(piece.cut_line);
    laid.grain_line = placement.placed(piece.grain_line);
    for (DrawnLine& line : laid.lines) line.points = placement.placed(line.points);
    for (PieceNotch& notch : laid.notches) {
        notch.outward = at(notch.outward) - origin;
        notch.on_sew = at(notch.on_sew);
    }
    for (Label& label : laid.labels) {
        label.middle = at(label.middle);
        label.turn = upright(placement.turn + (placement.is_drawn_mirrored() ? -label.turn : label.turn));
        if (label.text == piece.name) label.text = laid.name;
    }
    if (placement.is_drawn_mirrored()) run_backwards(laid);
    const int copies = piece.quantity + piece.quantity_mirrored;
    if (copies > 1) laid.name += " " + std::to_string(placement.copy) + "/" + std::to_string(copies);
    return laid;
}

}  // namespace ripstop
