#include "support/openings.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop::testing {
namespace {

Points2 line_of(const std::vector<Vec2>& points) {
    Points2 line(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) line.row(static_cast<Eigen::Index>(i)) = points[i];
    return line;
}

std::vector<Points2> sides_of(const std::vector<Vec2>& corners) {
    std::vector<Points2> sides;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back(line_of({corners[i], corners[(i + 1) % corners.size()]}));
    return sides;
}

Points2 arc(double radius, double from, double to, int chords) {
    Points2 line(chords + 1, 2);
    for (int i = 0; i <= chords; ++i) {
        const double angle = from + (to - from) * i / chords;
        line.row(i) << radius * std::cos(angle), radius * std::sin(angle);
    }
    return line;
}

}  // namespace

std::vector<AllowedEdge> hemmed(const std::vector<Points2>& edges, double allowance) {
    std::vector<AllowedEdge> allowed;
    for (const Points2& edge : edges) allowed.push_back({edge, allowance, CornerRule::hem});
    return allowed;
}

std::vector<AllowedEdge> square_keyhole(double slit, double side, double allowance) {
    const double size = keyhole_size, depth = keyhole_depth, middle = size / 2;
    std::vector<Vec2> corners{{middle + slit / 2, 0}, {size, 0}, {size, size}, {0, size}, {0, 0},
                              {middle - slit / 2, 0}};
    if (slit < side) corners.insert(corners.end(), {{middle - slit / 2, depth}, {middle - side / 2, depth}});
    corners.insert(corners.end(), {{middle - side / 2, depth + side}, {middle + side / 2, depth + side}});
    if (slit < side) corners.insert(corners.end(), {{middle + side / 2, depth}, {middle + slit / 2, depth}});
    return hemmed(sides_of(corners), allowance);
}

std::vector<AllowedEdge> round_keyhole(double slit, double radius, double allowance) {
    const double size = keyhole_size, middle = size / 2, half = std::asin(slit / 2 / radius);
    const double down = -std::numbers::pi / 2;
    Points2 circle = arc(radius, down - half, down + half - 2 * std::numbers::pi, 48);
    circle.array() += middle;
    const Vec2 left = circle.row(0), right = circle.row(48), left_mouth(left.x(), 0), right_mouth(right.x(), 0);
    std::vector<Points2> edges = sides_of({right_mouth, {size, 0}, {size, size}, {0, size}, {0, 0}, left_mouth, left});
    edges.back() = circle;
    edges.push_back(line_of({right, right_mouth}));
    return hemmed(edges, allowance);
}

std::vector<AllowedEdge> open_ring(double angle, double allowance, double radius) {
    const Points2 outer = arc(radius, 0, angle, 72), inner = arc(0.3 * radius, angle, 0, 72);
    std::vector<AllowedEdge> edges = hemmed(
        {outer, line_of({outer.row(72), inner.row(0)}), inner, line_of({inner.row(72), outer.row(0)})}, allowance);
    edges[1].corner = edges[3].corner = CornerRule::mitre;
    return edges;
}

std::vector<AllowedEdge> notched_strip(double angle, double allowance) {
    const double half = 0.5 * std::tan(angle / 2);
    const double side = 0.5 + std::max(half, 0.5);
    return hemmed(sides_of({{-side, 0}, {side, 0}, {side, 1}, {half, 1}, {0, 0.5}, {-half, 1}, {-side, 1}}), allowance);
}

PatternPiece cut_piece(const std::vector<AllowedEdge>& edges) {
    PatternPiece piece;
    piece.name = piece.file = "piece";
    std::vector<Vec2> points;
    for (const AllowedEdge& edge : edges) {
        double length = 0;
        const int first = static_cast<int>(points.size());
        for (Eigen::Index i = 0; i + 1 < edge.sew_line.rows(); ++i) {
            points.emplace_back(edge.sew_line.row(i));
            length += (edge.sew_line.row(i + 1) - edge.sew_line.row(i)).norm();
        }
        piece.edges.push_back({first, length, edge.allowance, edge.corner == CornerRule::hem ? "hem" : "flat-felled"});
    }
    piece.sew_line = line_of(points);
    CutLine cut = make_cut_line(edges);
    piece.cut_line = std::move(cut.points);
    piece.met = std::move(cut.met);
    return piece;
}

int turns_round(const Points2& line, const Vec2& point) {
    double angle = 0;
    for (Eigen::Index i = 0; i < line.rows(); ++i) {
        const Vec2 a = Vec2(line.row(i)) - point, b = Vec2(line.row((i + 1) % line.rows())) - point;
        angle += std::atan2(cross(a, b), a.dot(b));
    }
    return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

PatternPiece as_written(const PatternPiece& piece, const Points2& cut_line, const Points2& sew_line) {
    const auto forward = [](const Points2& line) {
        return signed_area(line) < 0 ? Points2(line.colwise().reverse()) : line;
    };
    const Eigen::RowVector2d shift = piece.cut_line.colwise().minCoeff() - cut_line.colwise().minCoeff();
    PatternPiece written = piece;
    written.cut_line = forward(cut_line).rowwise() + shift;
    const Points2 sew = forward(sew_line).rowwise() + shift;
    const Eigen::Index count = sew.rows();
    Eigen::Index start = 0;  // among coinciding places, the first from which the line continues as the piece does
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < count; ++i) {
        const double off =
            (sew.row(i) - piece.sew_line.row(0)).norm() + (sew.row((i + 1) % count) - piece.sew_line.row(1)).norm();
        if (!(off < least)) continue;
        least = off;
        start = i;
    }
    written.sew_line = sew;
    for (Eigen::Index i = 0; i < count; ++i) written.sew_line.row(i) = sew.row((start + i) % count);
    return written;
}

}  // namespace ripstop::testing
