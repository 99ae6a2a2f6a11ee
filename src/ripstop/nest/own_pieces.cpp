#include "ripstop/nest/own_pieces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

/// The furthest a point of `from`, turned and mirrored about its middle, lies off `to` about its own [m].
double misfit(const PatternPiece& from, const PatternPiece& to, const Vec2& signs) {
    const Vec2 middle = area_centroid(from.outline()), there = area_centroid(to.outline());
    double most = 0;
    for (Eigen::Index i = 0; i < from.outline().rows(); ++i) {
        const Vec2 point = (Vec2(from.outline().row(i)) - middle).cwiseProduct(signs) + there;
        most = std::max(most, distance_to_outline(to.outline(), point));
    }
    return most;
}

/// Where `own` has to lie to cover what `copy` of `pattern` covers.
Placement covering(const Placement& copy, const PatternPiece& pattern, const PatternPiece& own, std::size_t piece) {
    const double mirror = own.mirrored ? -1 : 1;
    const bool half_turn = misfit(own, pattern, {-1, -mirror}) < misfit(own, pattern, {1, mirror});
    Placement placement = copy;
    placement.piece = piece;
    placement.copy = 0;
    placement.mirrored = false;
    placement.face_down = copy.is_drawn_mirrored() != own.mirrored;
    if (half_turn) placement.turn += copy.turn > std::numbers::pi / 2 ? -std::numbers::pi : std::numbers::pi;
    placement.shift = Vec2::Zero();
    const auto middle_as = [](const Placement& as, const PatternPiece& laid) -> Vec2 {
        return as.placed(Points2(area_centroid(laid.outline()).transpose())).row(0).transpose();
    };
    placement.shift = middle_as(copy, pattern) - middle_as(placement, own);
    return placement;
}

}  // namespace

void lay_own_pieces(const PieceSet& set, Marker& marker) {
    std::map<std::string, std::size_t> patterns;
    for (std::size_t i = 0; i < set.pieces.size(); ++i)
        if (set.pieces[i].pattern.empty()) patterns.emplace(set.pieces[i].name, i);
    // the pieces each pattern cuts, and those it cuts turned over, the last first
    std::map<std::pair<std::size_t, bool>, std::vector<std::size_t>> waiting;
    for (std::size_t i = set.pieces.size(); i-- > 0;) {
        const PatternPiece& piece = set.pieces[i];
        const auto pattern = patterns.find(piece.pattern.empty() ? piece.name : piece.pattern);
        if (pattern != patterns.end()) waiting[{pattern->second, piece.mirrored}].push_back(i);
    }
    for (const auto& [kind, own] : waiting) {
        const auto& [first, mirrored] = kind;
        const PatternPiece& pattern = set.pieces[first];
        auto next = own.rbegin();
        if (static_cast<int>(own.size()) != (mirrored ? pattern.quantity_mirrored : pattern.quantity)) continue;
        for (Placement& placement : marker.placements) {
            if (placement.copy == 0 || placement.piece != first || placement.mirrored != mirrored) continue;
            placement = covering(placement, pattern, set.pieces[*next], *next);
            ++next;
        }
    }
}

}  // namespace ripstop
