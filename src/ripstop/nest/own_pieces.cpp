#include "ripstop/nest/own_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

/// The largest distance of the points of `from`, turned and mirrored about its centre, from `to` about its own
/// [m].
double misfit(const PatternPiece& from, const PatternPiece& to, const Vec2& signs) {
    const Vec2 middle = area_centroid(from.outline()), there = area_centroid(to.outline());
    double most = 0;
    for (Eigen::Index i = 0; i < from.outline().rows(); ++i) {
        const Vec2 point = (Vec2(from.outline().row(i)) - middle).cwiseProduct(signs) + there;
        most = std::max(most, distance_to_outline(to.outline(), point));
    }
    return most;
}

bool covers_half_turned(const PatternPiece& own, const PatternPiece& pattern) {
    const double mirror = own.mirrored ? -1 : 1;
    return misfit(own, pattern, {-1, -mirror}) < misfit(own, pattern, {1, mirror});
}

bool lies_half_turned(double turn) {
    return std::cos(turn) < 0;
}

}  // namespace

OwnPieces::OwnPieces(const PieceSet& set) : set_(set) {
    std::map<std::string, std::size_t> patterns;
    for (std::size_t i = 0; i < set.pieces.size(); ++i)
        if (set.pieces[i].pattern.empty()) patterns.emplace(set.pieces[i].name, i);
    for (std::size_t i = set.pieces.size(); i-- > 0;) {
        const PatternPiece& piece = set.pieces[i];
        const auto found = patterns.find(piece.pattern.empty() ? piece.name : piece.pattern);
        if (found != patterns.end()) own_[{found->second, piece.mirrored}].push_back({i, false});
    }
    std::erase_if(own_, [&set](const auto& kind) {
        const PatternPiece& pattern = set.pieces[kind.first.first];
        const int wanted = kind.first.second ? pattern.quantity_mirrored : pattern.quantity;
        return static_cast<int>(kind.second.size()) != wanted || pattern.outline().rows() < 3;
    });
    for (auto& [kind, own] : own_)
        for (Own& one : own)
            one.half_turned = one.piece != kind.first && set.pieces[one.piece].outline().rows() >= 3 &&
                              covers_half_turned(set.pieces[one.piece], set.pieces[kind.first]);
}

int OwnPieces::half_turned(std::size_t pattern, bool mirrored) const {
    const auto own = own_.find({pattern, mirrored});
    if (own == own_.end()) return 0;
    return static_cast<int>(
        std::count_if(own->second.begin(), own->second.end(), [](const Own& one) { return one.half_turned; }));
}

OwnPieces::Own OwnPieces::take(std::vector<Own>& waiting, bool may_turn, double turn) {
    auto next = waiting.rbegin();
    if (!may_turn)
        next = std::find_if(waiting.rbegin(), waiting.rend(),
                            [turn](const Own& one) { return one.half_turned == lies_half_turned(turn); });
    const Own own = *next;
    waiting.erase(std::next(next).base());
    return own;
}

/// The placement at which a piece covers what the copy of its pattern covers.
Placement OwnPieces::covering(const Placement& copy, const Own& own) const {
    const PatternPiece &pattern = set_.pieces[copy.piece], &piece = set_.pieces[own.piece];
    Placement placement = copy;
    placement.piece = own.piece;
    placement.copy = 0;
    placement.mirrored = false;
    placement.face_down = copy.is_drawn_mirrored() != piece.mirrored;
    if (own.half_turned) placement.turn += lies_half_turned(copy.turn) ? -std::numbers::pi : std::numbers::pi;
    placement.shift = Vec2::Zero();
    const auto middle_as = [](const Placement& as, const PatternPiece& laid) -> Vec2 {
        return as.placed(Points2(area_centroid(laid.outline()).transpose())).row(0).transpose();
    };
    placement.shift = middle_as(copy, pattern) - middle_as(placement, piece);
    return placement;
}

void OwnPieces::lay(bool may_turn, Marker& marker) const {
    auto waiting = own_;
    for (Placement& placement : marker.placements) {
        const auto own = waiting.find({placement.piece, placement.mirrored});
        if (placement.copy == 0 || own == waiting.end()) continue;
        placement = covering(placement, take(own->second, may_turn, placement.turn));
    }
}

}  // namespace ripstop
