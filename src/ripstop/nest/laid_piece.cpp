#include "ripstop/nest/laid_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ripstop {
namespace {

Points2 reversed(const Points2& points) {
    return points.colwise().reverse();
}

/// Restores the orientation of a line that mirroring has made clockwise: reverses it from the start of its first
/// edge.
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
    for (MetAllowances& met : piece.met) {
        met.edge = static_cast<int>(count) - 1 - met.edge;
        met.mate_edge = static_cast<int>(count) - 1 - met.mate_edge;
    }
}

/// The angle modulo half a turn, within a quarter turn of zero, so that text stays readable.
double turned_upright(double turn) {
    turn = std::remainder(turn, 2 * std::numbers::pi);
    constexpr double quarter = std::numbers::pi / 2 + 1e-9;
    if (turn > quarter) turn -= std::numbers::pi;
    if (turn < -quarter) turn += std::numbers::pi;
    return turn;
}

Vec2 up_of(const Label& label) {
    return {-std::sin(label.turn), std::cos(label.turn)};
}

/// True if the second label is the line of text below the first.
bool is_next_line(const Label& first, const Label& second) {
    const Vec2 down = second.middle - first.middle, up = up_of(first);
    return first.turn == second.turn && std::abs(down.x() * up.y() - down.y() * up.x()) < 1e-9 && down.dot(up) < 0 &&
           -down.dot(up) < 2 * (first.height + second.height);
}

/// Keeps stacked lines in reading order. If the piece lies so that they would read from last to first, rotates the
/// whole stack about its middle, within its room.
void lay_labels(const std::vector<Label>& old, std::vector<Label>& labels) {
    for (std::size_t first = 0, next; first < labels.size(); first = next) {
        for (next = first + 1; next < labels.size() && is_next_line(old[next - 1], old[next]);) ++next;
        const Label &top = labels[first], &bottom = labels[next - 1];
        const Vec2 up = up_of(top);
        if (next == first + 1 || (bottom.middle - top.middle).dot(up) < 0) continue;
        const Vec2 ends = (top.middle - top.height / 2 * up) + (bottom.middle + bottom.height / 2 * up);
        for (std::size_t i = first; i < next; ++i) labels[i].middle = ends - labels[i].middle;
    }
}

}  // namespace

PatternPiece laid_piece(const PatternPiece& piece, const Placement& placement) {
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
    for (MetAllowances& met : laid.met) met.at = at(met.at);
    const int copies = piece.quantity + piece.quantity_mirrored;
    const std::string copy = std::to_string(placement.copy) + "/" + std::to_string(copies);
    for (Label& label : laid.labels) {
        label.middle = at(label.middle);
        label.turn = turned_upright(placement.turn + (placement.is_drawn_mirrored() ? -label.turn : label.turn));
        if (label.text == piece.name) label.text = laid.name;
    }
    lay_labels(piece.labels, laid.labels);
    if (placement.copy == 0) std::erase_if(laid.labels, [](const Label& label) { return label.counts; });
    for (Label& label : laid.labels)
        if (label.counts) label.text = copy;
    if (placement.is_drawn_mirrored()) run_backwards(laid);
    if (placement.copy > 0 && copies > 1) laid.name += " " + copy;
    return laid;
}

}  // namespace ripstop
