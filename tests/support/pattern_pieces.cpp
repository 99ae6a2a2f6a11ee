#include "support/pattern_pieces.h"

#include <cmath>
#include <numbers>

#include "ripstop/geometry/polygon.h"

namespace ripstop::testing {
namespace {

/// Counter-clockwise from the lower left corner; extended outwards by `grown` on all sides.
Points2 bowed(double length, double width, double bow, double grown) {
    constexpr int steps = 24;
    std::vector<Vec2> points;
    const double left = -grown, right = length + grown;
    const auto rise = [&](int i) { return bow * std::sin(std::numbers::pi * i / steps); };
    for (int i = 0; i <= steps; ++i) points.emplace_back(left + (right - left) * i / steps, -grown - rise(i));
    for (int i = steps; i >= 0; --i) points.emplace_back(left + (right - left) * i / steps, width + grown + rise(i));
    Points2 rows(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
}

PieceNotch notch(int edge, const std::string& seam, const Vec2& on_sew, const Vec2& outward, int count) {
    PieceNotch mark;
    mark.edge = edge;
    mark.seam = seam;
    mark.on_sew = on_sew;
    mark.outward = outward;
    mark.reach = 0.012;
    mark.depth = 0.004;
    mark.count = count;
    return mark;
}

}  // namespace

PatternPiece band(const std::string& name, double length, double width, double bow) {
    constexpr double allowance = 0.012;
    PatternPiece piece;
    piece.name = name;
    piece.file = "band";
    piece.sew_line = bowed(length, width, bow, 0);
    piece.cut_line = bowed(length, width, bow, allowance);
    const int corner = static_cast<int>(piece.sew_line.rows()) / 2;
    const double side = width;
    piece.edges = {
        {0, 0, allowance, "flat-felled", {{"S001", "neighbour below", length}}},
        {corner - 1, side, allowance, "hem"},
        {corner, 0, allowance, "flat-felled", {{"S002", "B\u00edl\u00fd", length / 2}, {"S003", "C", length / 2}}},
        {2 * corner - 1, side, allowance, "hem"}};
    for (const std::size_t long_edge : {0U, 2U}) {
        const Points2 line = piece.edge_line(long_edge);
        for (Eigen::Index i = 0; i + 1 < line.rows(); ++i)
            piece.edges[long_edge].length += (line.row(i + 1) - line.row(i)).norm();
    }
    piece.notches = {notch(0, "S001", {length / 2, -bow}, {0, -1}, 1),
                     notch(2, "S002", {length / 2, width + bow}, {0, 1}, 2)};
    piece.grain_line.resize(2, 2);
    piece.grain_line << 0.3 * length, 0.6 * width, 0.7 * length, 0.6 * width;
    DrawnLine tape{"tape", Points2(2, 2)};
    tape.points << 0.2 * length, 0.1 * width, 0.2 * length, 0.9 * width;
    piece.lines = {tape};
    piece.labels = {{name, {length / 2, width / 2}, std::min(0.02, width / 8), 0}};
    return piece;
}

std::vector<PatternPiece> odd_pieces() {
    std::vector<PatternPiece> pieces{band("G01P01", 0.5, 0.3, 0.02), band("B\u00edl\u00fd \u0416\u03a9 <&>", 0.4, 0.2),
                                     band("", 0.3, 0.1), band("upright", 0.05, 0.6)};
    pieces[1].edges.clear();
    pieces[1].notches.clear();
    pieces[1].quantity = 2;
    pieces[1].quantity_mirrored = 3;
    pieces[2].cut_line.resize(0, 2);
    pieces[2].notches.clear();
    pieces[3].labels[0].turn = std::numbers::pi / 2;
    for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].file = std::string("odd").append(std::to_string(i));
    return pieces;
}

std::vector<PatternPiece> many_pieces(int count) {
    std::vector<PatternPiece> pieces;
    for (int i = 0; i < count; ++i) {
        pieces.push_back(band(std::string("P").append(std::to_string(i + 1)), 0.3, 0.15, 0.01));
        pieces.back().file = pieces.back().name;
    }
    return pieces;
}

double cut_length(const PatternPiece& piece) {
    return perimeter(piece.outline());
}

}  // namespace ripstop::testing
