#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The shape of the cut line at the corners at the ends of an edge.
enum class CornerRule {
    mitre,   ///< the allowances extend until they meet; a sharp corner is cut across at twice the larger allowance
    square,  ///< cut across, at the distance of the larger allowance from the corner
    fold,    ///< the end of the allowance mirrors the piece about the sew line, so that it matches when folded back
    hem,     ///< as `fold`, with priority: a hem is folded after the seam beside it is sewn
};

/// A corner of the sew line and the allowances that end there.
struct SewCorner {
    Vec2 at;
    Vec2 in, out;                        ///< unit directions into and out of it, along the sew line
    double reach_in = 0, reach_out = 0;  ///< [m]
    CornerRule rule_in = CornerRule::mitre, rule_out = CornerRule::mitre;

    Vec2 away_in() const { return {in.y(), -in.x()}; }
    Vec2 away_out() const { return {out.y(), -out.x()}; }
    Vec2 end_in() const { return at + reach_in * away_in(); }
    Vec2 end_out() const { return at + reach_out * away_out(); }
};

/// No point of a corner is farther from it than this times the larger allowance.
inline constexpr double furthest_corner = 2.5;

/// The intersection of the lines p + s u and q + t v; false if they are parallel.
bool lines_meet(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v, Vec2& at);

/// The cut line around a corner that turns outward, between `end_in` and `end_out`, both excluded; see
/// `make_cut_line`.
std::vector<Vec2> corner_points(const SewCorner& corner);

}  // namespace ripstop
