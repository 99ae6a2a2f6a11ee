#include "support/loose_pieces.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/predicates.h"
#include "ripstop/nest/laid_piece.h"

namespace ripstop::testing {
namespace {

constexpr double rounding = 1e-8;  // [m]; coordinates reach 1 km

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0;
}

/// Zero if they overlap.
double distance_between(const Points2& a, const Points2& b) {
    if (contains(a, Vec2(b.row(0))) || contains(b, Vec2(a.row(0)))) return 0;
    double least = 1e9;
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        for (Eigen::Index k = 0; k < b.rows(); ++k)
            if (cross_each_other(a.row(i), a.row((i + 1) % a.rows()), b.row(k), b.row((k + 1) % b.rows()))) return 0;
    for (Eigen::Index i = 0; i < a.rows(); ++i) least = std::min(least, distance_to_outline(b, a.row(i)));
    for (Eigen::Index k = 0; k < b.rows(); ++k) least = std::min(least, distance_to_outline(a, b.row(k)));
    return least;
}

struct Laid {
    std::string name;
    Points2 outline;
    Vec2 lower, upper;
};

bool is_over_a_join(const Laid& piece, const std::vector<double>& parts) {
    double join = 0;
    for (std::size_t i = 0; !parts.empty() && join < piece.upper.x() - rounding; ++i) {
        if (join > piece.lower.x() + rounding) return true;
        join += parts[std::min(i, parts.size() - 1)];
    }
    return false;
}

std::string faults_of(const Marker& marker, const std::vector<Laid>& laid, double gap,
                      const std::vector<double>& parts) {
    std::string faults;
    for (std::size_t i = 0; i < laid.size(); ++i) {
        const Laid& a = laid[i];
        if (a.lower.minCoeff() < -rounding || a.upper.y() > marker.roll_width + rounding ||
            a.upper.x() > marker.length + rounding)
            faults += a.name + " is not on the roll\n";
        if (is_over_a_join(a, parts)) faults += a.name + " lies over a join\n";
        for (std::size_t k = i + 1; k < laid.size(); ++k) {
            const Laid& b = laid[k];
            if (((b.lower - a.upper).array() > gap).any() || ((a.lower - b.upper).array() > gap).any()) continue;
            const double distance = distance_between(a.outline, b.outline);
            if (distance < gap - rounding || distance == 0)
                faults += a.name + " and " + b.name + " are " + std::to_string(distance) + " m apart\n";
        }
    }
    return faults;
}

}  // namespace

PatternPiece loose_piece(const std::string& name, const Points2& outline) {
    PatternPiece piece{name, outline};
    piece.file = name;
    piece.fabric = Fabric().name;
    return piece;
}

PatternPiece rectangle_piece(const std::string& name, double length, double height) {
    Points2 outline(4, 2);
    outline << 0, 0, length, 0, length, height, 0, height;
    return loose_piece(name, outline);
}

PieceSet loose_set(std::vector<PatternPiece> pieces) {
    return {"loose.obj", "A", std::move(pieces), {Fabric()}, {}};
}

std::vector<PatternPiece> gore_like_pieces(int count) {
    std::mt19937 random(1);
    const auto between = [&random](double a, double b) {
        return a + (b - a) * (static_cast<double>(random()) / 4294967296.0);
    };
    std::vector<PatternPiece> pieces;
    for (int n = 0; n < count; ++n) {
        const double length = between(1.5, 4), width = between(0.25, 0.85);
        const double start = between(0.02, 0.4), end = between(0.6, 0.98);  // of half a wave
        const auto height = [&](int i) { return std::sin(std::numbers::pi * (start + (end - start) * i / 10)); };
        double highest = 0;
        for (int i = 0; i <= 10; ++i) highest = std::max(highest, height(i));
        Points2 outline(22, 2);
        for (int i = 0; i <= 10; ++i) {
            outline.row(i) << length * i / 10, -0.5 * width * height(i) / highest;
            outline.row(21 - i) << length * i / 10, 0.5 * width * height(i) / highest;
        }
        pieces.push_back(loose_piece(std::string("P").append(std::to_string(n + 1)), outline));
    }
    return pieces;
}

std::string faults_of(const PieceSet& set, const Markers& markers, double gap, const std::vector<double>& parts) {
    std::string faults;
    std::map<std::string, std::pair<int, int>> copies;  // straight, mirrored
    for (const Marker& marker : markers.markers) {
        std::vector<Laid> laid;
        for (const Placement& placement : marker.placements) {
            const PatternPiece& piece = set.pieces[placement.piece];
            if (piece.fabric != marker.fabric || piece.colour != marker.colour)
                faults += piece.name + ": wrong cloth\n";
            ++(placement.mirrored ? copies[piece.name].second : copies[piece.name].first);
            const Points2 outline = laid_piece(piece, placement).outline();
            laid.push_back({piece.name, outline, outline.colwise().minCoeff(), outline.colwise().maxCoeff()});
            if (signed_area(outline) <= 0) faults += piece.name + " runs clockwise\n";
        }
        faults += faults_of(marker, laid, gap, parts);
    }
    for (const Refusal& refusal : markers.refusals) copies.erase(refusal.piece);
    for (const PatternPiece& piece : set.pieces) {
        bool is_refused = false;
        for (const Refusal& refusal : markers.refusals) is_refused = is_refused || refusal.piece == piece.name;
        if (!is_refused && copies[piece.name] != std::pair(piece.quantity, piece.quantity_mirrored))
            faults += piece.name + " is laid " + std::to_string(copies[piece.name].first) + " times\n";
    }
    return faults;
}

}  // namespace ripstop::testing
