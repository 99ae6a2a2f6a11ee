#include "ripstop/pattern/cut/cut_corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

constexpr double mitre_limit = 2;   // times the larger allowance
constexpr double least_rise = 0.2;  // of a fold: a flatter one would end far out

/// Extends both allowances until they meet. Beyond the limit, cuts across at right angles to the corner's
/// bisector. If one allowance is so wide that they would meet behind the end of the other, adds nothing between
/// the two ends.
void add_mitre(std::vector<Vec2>& contour, const SewCorner& corner, double limit) {
    const Vec2 a = corner.end_in(), b = corner.end_out();
    Vec2 tip;
    if (!lines_meet(a, corner.in, b, corner.out, tip) || (tip - a).dot(corner.in) < 0 || (tip - b).dot(corner.out) > 0)
        return;
    if ((tip - corner.at).norm() <= limit) {
        contour.push_back(tip);
        return;
    }
    const Vec2 middle = (corner.in - corner.out).normalized();
    const Vec2 end = corner.at + limit * middle, across(-middle.y(), middle.x());
    Vec2 from_a, from_b;
    if (lines_meet(a, corner.in, end, across, from_a) && lines_meet(b, corner.out, end, across, from_b) &&
        (from_a - a).dot(corner.in) >= 0 && (from_b - b).dot(corner.out) <= 0) {
        contour.push_back(from_a);
        contour.push_back(from_b);
    }
}

/// A hem that ends at a corner, and the other edge there.
struct HemEnd {
    Vec2 at;
    Vec2 hem;          ///< unit direction along the hem, into the corner
    Vec2 hem_outward;  ///< unit normal of the hem, away from the piece
    double hem_reach;
    Vec2 other;      ///< unit direction along the other edge, out of the corner
    Vec2 other_end;  ///< of the other edge's allowance, at the corner
};

/// The end of a hem: its tip, and where it meets the fold. It mirrors the other edge's cut line about the hem's
/// sew line. Nothing if the two are too close to parallel.
std::optional<std::array<Vec2, 2>> folded_end(const HemEnd& end) {
    const Vec2 mirrored = end.other - 2 * end.other.dot(end.hem_outward) * end.hem_outward;
    const double rise = mirrored.dot(end.hem_outward);
    Vec2 turn;
    if (rise < least_rise || !lines_meet(end.at, end.hem, end.other_end, end.other, turn)) return std::nullopt;
    const Vec2 tip = turn + end.hem_reach / rise * mirrored;
    const double furthest = std::max((tip - end.at).norm(), (turn - end.at).norm());
    if (furthest > furthest_corner * std::max(end.hem_reach, (end.other_end - end.at).norm())) return std::nullopt;
    return std::array<Vec2, 2>{tip, turn};
}

}  // namespace

bool lines_meet(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v, Vec2& at) {
    const double sine = cross(u, v);
    if (std::abs(sine) < 1e-9) return false;
    at = p + cross(q - p, v) / sine * u;
    return true;
}

std::vector<Vec2> corner_points(const SewCorner& corner) {
    const auto& [at, in, out, reach_in, reach_out, rule_in, rule_out] = corner;
    const bool hem_in = rule_in == CornerRule::hem, hem_out = rule_out == CornerRule::hem;
    const bool fold_in = hem_in != hem_out ? hem_in : !hem_in && rule_in == CornerRule::fold;
    const bool fold_out = hem_in != hem_out ? hem_out : !hem_in && !fold_in && rule_out == CornerRule::fold;
    if (fold_in)
        if (const auto end = folded_end({at, in, corner.away_in(), reach_in, out, corner.end_out()}))
            return {(*end)[0], (*end)[1]};
    if (fold_out)
        if (const auto end = folded_end({at, -out, corner.away_out(), reach_out, -in, corner.end_in()}))
            return {(*end)[1], (*end)[0]};
    const bool is_square = rule_in == CornerRule::square || rule_out == CornerRule::square;
    std::vector<Vec2> points;
    add_mitre(points, corner, (is_square ? 1 : mitre_limit) * std::max(reach_in, reach_out));
    return points;
}

}  // namespace ripstop
