#include "ripstop/pattern/revision/compare_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ripstop {
namespace {

struct NotchPlace {
    double along;  ///< along the edge, from its start [m]
    const PieceNotch* notch;
};

double place_along(const Points2& line, const Vec2& point) {
    double along = 0, best = 0, nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
        const Vec2 from = line.row(i), way = Vec2(line.row(i + 1)) - from;
        const double length = way.norm();
        if (length == 0) continue;
        const double at = std::clamp((point - from).dot(way) / length, 0.0, length);
        const double distance = (from + at / length * way - point).norm();
        if (distance < nearest) {
            nearest = distance;
            best = along + at;
        }
        along += length;
    }
    return best;
}

/// The notches of each edge, in order along it.
std::vector<std::vector<NotchPlace>> notch_places(const PatternPiece& piece) {
    std::vector<std::vector<NotchPlace>> places(piece.edges.size());
    for (const PieceNotch& notch : piece.notches) {
        const auto edge = static_cast<std::size_t>(notch.edge);
        places[edge].push_back({place_along(piece.edge_line(edge), notch.on_sew), &notch});
    }
    for (auto& edge : places)
        std::sort(edge.begin(), edge.end(), [](const NotchPlace& a, const NotchPlace& b) { return a.along < b.along; });
    return places;
}

/// The start and the middle of each edge (2 #edges x 2).
Points2 marks_of(const PatternPiece& piece) {
    Points2 marks(2 * static_cast<Eigen::Index>(piece.edges.size()), 2);
    for (std::size_t e = 0; e < piece.edges.size(); ++e) {
        const Points2 line = piece.edge_line(e);
        double half = 0;
        for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) half += (line.row(i + 1) - line.row(i)).norm() / 2;
        Vec2 middle = line.row(0);
        for (Eigen::Index i = 0; i + 1 < line.rows() && half >= 0; ++i) {
            const Vec2 way = line.row(i + 1) - line.row(i);
            const double length = way.norm();
            if (length > 0) middle = Vec2(line.row(i)) + std::min(1.0, half / length) * way;
            half -= length;
        }
        const auto row = 2 * static_cast<Eigen::Index>(e);
        marks.row(row) = line.row(0);
        marks.row(row + 1) = middle.transpose();
    }
    return marks;
}

/// The offset between the edge numbers of `b` and those of `a`.
std::size_t shift_of_numbers(const PatternPiece& a, const PatternPiece& b, const OutlineFit& motion) {
    const Points2 from = motion.moved(marks_of(a)), to = marks_of(b);
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t shift = 0; shift < a.edges.size(); ++shift) {
        double square = 0;
        for (Eigen::Index i = 0; i < from.rows(); ++i)
            square += (from.row(i) - to.row((i + 2 * static_cast<Eigen::Index>(shift)) % to.rows())).squaredNorm();
        if (square >= least - 1e-12) continue;
        least = square;
        best = shift;
    }
    return best;
}

std::vector<EdgeMate> mates_of(const PieceEdge& edge) {
    std::vector<EdgeMate> mates;
    for (const Mate& mate : edge.mates) mates.push_back({mate.piece, mate.length});
    return mates;
}

bool are_same(const std::vector<EdgeMate>& a, const std::vector<EdgeMate>& b, double tolerance) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [tolerance](const EdgeMate& one, const EdgeMate& other) {
        return one.piece == other.piece && std::abs(one.length - other.length) <= tolerance;
    });
}

int doubles(const std::vector<NotchPlace>& places) {
    return static_cast<int>(
        std::count_if(places.begin(), places.end(), [](const NotchPlace& place) { return place.notch->count > 1; }));
}

void compare_notches(const std::vector<NotchPlace>& a, const std::vector<NotchPlace>& b, double tolerance,
                     EdgeChange& change) {
    change.notches_before = static_cast<int>(a.size());
    change.notches_after = static_cast<int>(b.size());
    change.doubles_before = doubles(a);
    change.doubles_after = doubles(b);
    if (a.size() != b.size()) return;
    double deepest = tolerance;
    for (std::size_t i = 0; i < a.size(); ++i) {
        change.notch_moved = std::max(change.notch_moved, std::abs(b[i].along - a[i].along));
        const double deeper = std::abs(b[i].notch->depth - a[i].notch->depth);
        if (deeper <= deepest) continue;
        deepest = deeper;
        change.notch_depth_before = a[i].notch->depth;
        change.notch_depth_after = b[i].notch->depth;
    }
}

bool is_change(const EdgeChange& change, double tolerance) {
    return std::abs(change.length_after - change.length_before) > tolerance ||
           std::abs(change.allowance_after - change.allowance_before) > tolerance ||
           change.type_before != change.type_after || change.notches_before != change.notches_after ||
           change.notch_moved > tolerance || change.notch_depth_before != change.notch_depth_after ||
           change.doubles_before != change.doubles_after ||
           !are_same(change.mates_before, change.mates_after, tolerance);
}

}  // namespace

std::vector<EdgeChange> compare_edges(const PatternPiece& a, const PatternPiece& b, const OutlineFit& motion,
                                      double tolerance) {
    std::vector<EdgeChange> changes;
    if (a.edges.size() != b.edges.size() || a.edges.empty()) return changes;
    const auto places_a = notch_places(a), places_b = notch_places(b);
    const std::size_t shift = shift_of_numbers(a, b, motion);
    for (std::size_t e = 0; e < a.edges.size(); ++e) {
        const std::size_t other = (e + shift) % b.edges.size();
        const PieceEdge &before = a.edges[e], &after = b.edges[other];
        EdgeChange change;
        change.edge = static_cast<int>(e);
        change.edge_after = static_cast<int>(other);
        change.length_before = before.length;
        change.length_after = after.length;
        change.allowance_before = before.allowance;
        change.allowance_after = after.allowance;
        change.type_before = before.seam_type;
        change.type_after = after.seam_type;
        change.mates_before = mates_of(before);
        change.mates_after = mates_of(after);
        compare_notches(places_a[e], places_b[other], tolerance, change);
        if (!is_change(change, tolerance)) continue;
        if (are_same(change.mates_before, change.mates_after, tolerance)) change.mates_after = change.mates_before;
        changes.push_back(std::move(change));
    }
    return changes;
}

}  // namespace ripstop
