#include "ripstop/pattern/compare_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr int samples = 200;
constexpr int most_steps = 100;

Points2 evenly_spaced(const Points2& outline) {
    const double spacing = perimeter(outline) / samples;
    Points2 points(samples, 2);
    double left = 0;
    int next = 0;
    for (Eigen::Index i = 0; i < outline.rows() && next < samples; ++i) {
        const Vec2 from = outline.row(i), to = outline.row((i + 1) % outline.rows());
        const double length = (to - from).norm();
        for (; left <= length && next < samples && length > 0; left += spacing)
            points.row(next++) = (from + left / length * (to - from)).transpose();
        left -= length;
    }
    for (; next < samples; ++next) points.row(next) = outline.row(0);  // rounding of the last
    return points;
}

Vec2 nearest_on(const Points2& outline, const Vec2& point) {
    Vec2 best = outline.row(0);
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Vec2 from = outline.row(i), way = Vec2(outline.row((i + 1) % outline.rows())) - from;
        const double square = way.squaredNorm();
        const double along = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
        const Vec2 at = from + along * way;
        if ((at - point).squaredNorm() < (best - point).squaredNorm()) best = at;
    }
    return best;
}

Points2 moved(const Points2& points, double turn, const Vec2& from, const Vec2& to) {
    const double cosine = std::cos(turn), sine = std::sin(turn);
    const Mat22 rotation{{cosine, -sine}, {sine, cosine}};
    Points2 result(points.rows(), 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        result.row(i) = (rotation * (Vec2(points.row(i)) - from) + to).transpose();
    return result;
}

double furthest(const Points2& points, const Points2& outline) {
    double most = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) most = std::max(most, distance_to_outline(outline, points.row(i)));
    return most;
}

/// Direction of the longest spread of points.
double principal_axis(const Points2& points) {
    const Points2 centred = points.rowwise() - points.colwise().mean();
    const Mat22 spread = centred.transpose() * centred;
    return 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
}

OutlineFit fit_from(const Points2& a, const Points2& b, double turn) {
    const Points2 points = evenly_spaced(a);
    const Vec2 centre = points.colwise().mean();
    Vec2 place = evenly_spaced(b).colwise().mean();
    double square = 0;
    for (int step = 0; step < most_steps; ++step) {
        const Points2 at = moved(points, turn, centre, place);
        Points2 nearest(samples, 2);
        for (Eigen::Index i = 0; i < samples; ++i) nearest.row(i) = nearest_on(b, at.row(i)).transpose();
        const Vec2 goal = nearest.colwise().mean();
        double sine = 0, cosine = 0;
        square = 0;
        for (Eigen::Index i = 0; i < samples; ++i) {
            const Vec2 from = Vec2(at.row(i)) - place, to = Vec2(nearest.row(i)) - goal;
            sine += cross(from, to);
            cosine += from.dot(to);
            square += (at.row(i) - nearest.row(i)).squaredNorm();
        }
        const double more = std::atan2(sine, cosine);
        turn += more;
        const double shifted = (goal - place).norm();
        place = goal;
        if (std::abs(more) < 1e-12 && shifted < 1e-12) break;
    }
    const Points2 laid = moved(a, turn, centre, place);
    return {std::remainder(turn, 2 * std::numbers::pi), std::sqrt(square / samples), outline_distance(laid, b)};
}

/// Places of the notches of each edge, along it from its start.
std::vector<std::vector<double>> notch_places(const PatternPiece& piece) {
    std::vector<std::vector<double>> places(piece.edges.size());
    for (const PieceNotch& notch : piece.notches) {
        const Points2 line = piece.edge_line(static_cast<std::size_t>(notch.edge));
        double along = 0, best = 0, nearest = 1e300;
        for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
            const Vec2 from = line.row(i), way = Vec2(line.row(i + 1)) - from;
            const double length = way.norm();
            if (length == 0) continue;
            const double at = std::clamp((notch.on_sew - from).dot(way) / length, 0.0, length);
            const double distance = (from + at / length * way - notch.on_sew).norm();
            if (distance < nearest) {
                nearest = distance;
                best = along + at;
            }
            along += length;
        }
        places[static_cast<std::size_t>(notch.edge)].push_back(best);
    }
    for (auto& edge : places) std::sort(edge.begin(), edge.end());
    return places;
}

std::vector<EdgeChange> compare_edges(const PatternPiece& a, const PatternPiece& b, double tolerance) {
    std::vector<EdgeChange> changes;
    if (a.edges.size() != b.edges.size()) return changes;
    const auto places_a = notch_places(a), places_b = notch_places(b);
    for (std::size_t e = 0; e < a.edges.size(); ++e) {
        EdgeChange change{static_cast<int>(e),
                          a.edges[e].length,
                          b.edges[e].length,
                          a.edges[e].allowance,
                          b.edges[e].allowance,
                          a.edges[e].seam_type,
                          b.edges[e].seam_type,
                          static_cast<int>(places_a[e].size()),
                          static_cast<int>(places_b[e].size())};
        if (places_a[e].size() == places_b[e].size())
            for (std::size_t i = 0; i < places_a[e].size(); ++i)
                change.notch_moved = std::max(change.notch_moved, std::abs(places_b[e][i] - places_a[e][i]));
        if (std::abs(change.length_after - change.length_before) > tolerance ||
            std::abs(change.allowance_after - change.allowance_before) > tolerance ||
            change.type_before != change.type_after || change.notches_before != change.notches_after ||
            change.notch_moved > tolerance)
            changes.push_back(change);
    }
    return changes;
}

std::vector<FieldChange> compare_fields(const PatternPiece& a, const PatternPiece& b) {
    std::vector<FieldChange> changes;
    const auto compare = [&changes](const char* field, const std::string& before, const std::string& after) {
        if (before != after) changes.push_back({field, before, after});
    };
    compare("fabric", a.fabric, b.fabric);
    compare("colour", a.colour, b.colour);
    compare("quantity", std::to_string(a.quantity), std::to_string(b.quantity));
    compare("quantity_mirrored", std::to_string(a.quantity_mirrored), std::to_string(b.quantity_mirrored));
    return changes;
}

bool has_same_outline(const PatternPiece& a, const PatternPiece& b) {
    return a.outline().rows() == b.outline().rows() && a.outline() == b.outline();
}

/// Fills in what a piece measures in one revision.
void measure(const PatternPiece& piece, double& area, double& length, int& edges) {
    area = piece.outline().rows() < 3 ? 0 : signed_area(piece.outline());
    length = piece.sew_line.rows() < 2 ? 0 : perimeter(piece.sew_line);
    edges = static_cast<int>(piece.edges.size());
}

PieceChange compare(const PatternPiece& a, const PatternPiece& b, double tolerance) {
    PieceChange change{a.name};
    measure(a, change.area_before, change.perimeter_before, change.edges_before);
    measure(b, change.area_after, change.perimeter_after, change.edges_after);
    change.edges = compare_edges(a, b, tolerance);
    change.fields = compare_fields(a, b);
    if (has_same_outline(a, b) || a.outline().rows() < 3 || b.outline().rows() < 3) return change;
    change.distance = outline_distance(a.outline(), b.outline());
    const OutlineFit fit = fit_outline(a.outline(), b.outline());
    change.distance_fitted = std::min(fit.distance, change.distance);
    change.grain_turn = fit.distance < change.distance ? -fit.turn : 0;
    return change;
}

bool is_change(const PieceChange& change, const PatternPiece& piece, double tolerance) {
    const double size = piece.outline().rows() > 0 ? (piece.upper() - piece.lower()).norm() / 2 : 1;
    return change.edges_before != change.edges_after || !change.edges.empty() || !change.fields.empty() ||
           std::abs(change.area_after - change.area_before) > tolerance * change.perimeter_before ||
           std::abs(change.perimeter_after - change.perimeter_before) > tolerance ||
           change.distance_fitted > tolerance || std::abs(change.grain_turn) * size > tolerance;
}

}  // namespace

double outline_distance(const Points2& a, const Points2& b) {
    return std::max({furthest(a, b), furthest(b, a), furthest(evenly_spaced(a), b), furthest(evenly_spaced(b), a)});
}

OutlineFit fit_outline(const Points2& a, const Points2& b) {
    OutlineFit best = fit_from(a, b, 0);
    const double between = principal_axis(evenly_spaced(b)) - principal_axis(evenly_spaced(a));
    for (const double turn : {between, between + std::numbers::pi}) {
        const OutlineFit fit = fit_from(a, b, turn);
        if (fit.root_mean_square < 0.9 * best.root_mean_square - 1e-12) best = fit;
    }
    return best;
}

std::vector<PieceChange> compare_pieces(const PieceSet& before, const PieceSet& after, double tolerance) {
    std::map<std::string, const PatternPiece*> there;
    for (const PatternPiece& piece : after.pieces) there[piece.name] = &piece;
    std::vector<PieceChange> changes;
    for (const PatternPiece& piece : before.pieces) {
        const auto found = there.find(piece.name);
        if (found == there.end()) {
            PieceChange gone{piece.name, PieceChange::Kind::gone};
            measure(piece, gone.area_before, gone.perimeter_before, gone.edges_before);
            changes.push_back(gone);
            continue;
        }
        PieceChange change = compare(piece, *found->second, tolerance);
        if (is_change(change, piece, tolerance)) changes.push_back(std::move(change));
        there.erase(found);
    }
    for (const PatternPiece& piece : after.pieces) {
        if (there.count(piece.name) == 0) continue;
        PieceChange added{piece.name, PieceChange::Kind::added};
        measure(piece, added.area_after, added.perimeter_after, added.edges_after);
        changes.push_back(added);
    }
    return changes;
}

}  // namespace ripstop
