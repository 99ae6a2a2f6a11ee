#pragma once

#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// How the cut line goes round the corners at the ends of an edge.
enum class CornerRule {
    mitre,   ///< the allowances run on until they meet; on a sharp corner cut across at twice the larger from it
    square,  ///< cut across at the larger allowance from the corner
    fold,    ///< folded back about its sew line, the allowance ends where the piece does, its mirror image
    hem,     ///< as `fold`, and goes before it: a hem is folded when the seam beside it is sewn
};

/// A corner of the sew line and the allowances that end there.
struct SewCorner {
    Vec2 at;
    Vec2 in, out;                        ///< unit ways into and out of it along the sew line
    double reach_in = 0, reach_out = 0;  ///< [m]
    CornerRule rule_in = CornerRule::mitre, rule_out = CornerRule::mitre;

    Vec2 away_in() const { return {in.y(), -in.x()}; }
    Vec2 away_out() const { return {out.y(), -out.x()}; }
    Vec2 end_in() const { return at + reach_in * away_in(); }
    Vec2 end_out() const { return at + reach_out * away_out(); }
};

/// No point of a corner is further from it than this times the larger allowance.
inline constexpr double furthest_corner = 2.5;

/// Where the lines p + s u and q + t v meet; false where they are parallel.
bool lines_meet(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v, Vec2& at);

/// The cut line from `end_in` to `end_out`, both left out, round a corner that turns outward: see `make_cut_line`.
std::vector<Vec2> corner_points(const SewCorner& corner);

}  // namespace ripstop
