#include "ripstop/pattern/cut_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <polyclipping/clipper.hpp>

#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;

constexpr double steps_per_metre = 1e7;  // a tenth of a micrometre; 64 bits hold a million kilometres of it
constexpr double mitre_limit = 2;        // times the larger allowance
constexpr double fold_limit = 2.5;       // the same for the ends of a fold
constexpr double least_rise = 0.2;       // of a fold: flatter, its end would run far out
constexpr double same_point = 1e-9;      // [m]

IntPoint to_steps(const Vec2& p) {
    return {static_cast<cInt>(std::llround(p.x() * steps_per_metre)),
            static_cast<cInt>(std::llround(p.y() * steps_per_metre))};
}

/// Unit normal of a segment, away from a piece on its left.
Vec2 outward(const Vec2& from, const Vec2& to) {
    const Vec2 way = (to - from).normalized();
    return {way.y(), -way.x()};
}

/// Outside of a contour that may cross itself: the largest outline of what it goes round counter-clockwise.
Points2 outside_of(const std::vector<Vec2>& contour) {
    Path path;
    for (const Vec2& p : contour) path.push_back(to_steps(p));
    ClipperLib::Clipper clipper;
    clipper.AddPath(path, ClipperLib::ptSubject, true);
    ClipperLib::Paths parts;
    clipper.Execute(ClipperLib::ctUnion, parts, ClipperLib::pftPositive, ClipperLib::pftPositive);
    const auto largest = std::max_element(parts.begin(), parts.end(), [](const Path& a, const Path& b) {
        return ClipperLib::Area(a) < ClipperLib::Area(b);
    });
    if (largest == parts.end()) return Points2(0, 2);
    ClipperLib::CleanPolygon(*largest, 2);  // points within 0.2 micrometres of the line through their neighbours
    Points2 outline(static_cast<Eigen::Index>(largest->size()), 2);
    for (std::size_t i = 0; i < largest->size(); ++i)
        outline.row(static_cast<Eigen::Index>(i)) << static_cast<double>((*largest)[i].X) / steps_per_metre,
            static_cast<double>((*largest)[i].Y) / steps_per_metre;
    return outline;
}

/// Where the lines p + s u and q + t v meet; nothing where they are parallel.
bool meet(const Vec2& p, const Vec2& u, const Vec2& q, const Vec2& v, Vec2& at) {
    const double sine = cross(u, v);
    if (std::abs(sine) < 1e-9) return false;
    at = p + cross(q - p, v) / sine * u;
    return true;
}

/// The offset of an edge. Where it bends outward the offsets of two segments meet in a mitre; where it bends inward they
/// cross, and the way over the sew line makes the loop between them run clockwise.
void add_edge(std::vector<Vec2>& contour, const AllowedEdge& edge) {
    const double reach = edge.allowance;
    Vec2 before = Vec2::Zero();
    for (Eigen::Index i = 0; i + 1 < edge.sew_line.rows(); ++i) {
        const Vec2 from = edge.sew_line.row(i), to = edge.sew_line.row(i + 1);
        if ((to - from).norm() < same_point) continue;
        const Vec2 away = outward(from, to);
        if (before != Vec2::Zero()) {
            const Vec2 middle = (before + away).normalized();
            const double cosine = std::max(middle.dot(away), 1 / mitre_limit);
            contour.push_back(cross(before, away) > 0 ? Vec2(from + reach / cosine * middle) : from);
        }
        contour.push_back(from + reach * away);
        contour.push_back(to + reach * away);
        before = away;
    }
}

struct Corner {
    Vec2 at;
    Vec2 in, out;  ///< unit ways into and out of it along the sew line
    double reach_in, reach_out;

    Vec2 away_in() const { return {in.y(), -in.x()}; }
    Vec2 away_out() const { return {out.y(), -out.x()}; }
    Vec2 end_in() const { return at + reach_in * away_in(); }
    Vec2 end_out() const { return at + reach_out * away_out(); }
    bool turns_left() const { return cross(in, out) > 0; }
};

/// Both allowances run on until they meet; beyond the limit they are cut at right angles to the way out of the corner. Where
/// they would meet behind the end of one, that one being the wider by much, there is nothing between the two ends.
void add_mitre(std::vector<Vec2>& contour, const Corner& corner, double limit) {
    const Vec2 a = corner.end_in(), b = corner.end_out();
    Vec2 tip;
    if (!meet(a, corner.in, b, corner.out, tip) || (tip - a).dot(corner.in) < 0 || (tip - b).dot(corner.out) > 0)
        return;
    if ((tip - corner.at).norm() <= limit) {
        contour.push_back(tip);
        return;
    }
    const Vec2 middle = (corner.in - corner.out).normalized();
    const Vec2 end = corner.at + limit * middle, across(-middle.y(), middle.x());
    Vec2 from_a, from_b;
    if (meet(a, corner.in, end, across, from_a) && meet(b, corner.out, end, across, from_b) &&
        (from_a - a).dot(corner.in) >= 0 && (from_b - b).dot(corner.out) <= 0) {
        contour.push_back(from_a);
        contour.push_back(from_b);
    }
}

/// A hem that ends at a corner, and the other edge there.
struct HemEnd {
    Vec2 at;
    Vec2 hem;          ///< unit way along the hem, into the corner
    Vec2 hem_outward;  ///< unit normal of the hem, away from the piece
    double hem_reach;
    Vec2 other;      ///< unit way along the other edge, out of the corner
    Vec2 other_end;  ///< of the other edge's allowance, at the corner
};

/// The end of a hem: its tip, and where it meets the fold. It is the mirror image of the other edge's cut line about the hem's
/// sew line. Nothing where the two run too nearly alike for that.
std::optional<std::array<Vec2, 2>> folded_end(const HemEnd& end) {
    const Vec2 mirrored = end.other - 2 * end.other.dot(end.hem_outward) * end.hem_outward;
    const double rise = mirrored.dot(end.hem_outward);
    Vec2 turn;
    if (rise < least_rise || !meet(end.at, end.hem, end.other_end, end.other, turn)) return std::nullopt;
    const Vec2 tip = turn + end.hem_reach / rise * mirrored;
    const double furthest = std::max((tip - end.at).norm(), (turn - end.at).norm());
    if (furthest > fold_limit * std::max(end.hem_reach, (end.other_end - end.at).norm())) return std::nullopt;
    return std::array<Vec2, 2>{tip, turn};
}

void add_corner(std::vector<Vec2>& contour, const Corner& corner, CornerRule rule_in, CornerRule rule_out) {
    if (!corner.turns_left()) {
        contour.push_back(corner.at);
        return;
    }
    const auto& [at, in, out, reach_in, reach_out] = corner;
    const bool hem_in = rule_in == CornerRule::hem, hem_out = rule_out == CornerRule::hem;
    const bool fold_in = hem_in != hem_out ? hem_in : !hem_in && rule_in == CornerRule::fold;
    const bool fold_out = hem_in != hem_out ? hem_out : !hem_in && !fold_in && rule_out == CornerRule::fold;
    if (fold_in)
        if (const auto end = folded_end({at, in, corner.away_in(), reach_in, out, corner.end_out()})) {
            contour.push_back((*end)[0]);
            contour.push_back((*end)[1]);
            return;
        }
    if (fold_out)
        if (const auto end = folded_end({at, -out, corner.away_out(), reach_out, -in, corner.end_in()})) {
            contour.push_back((*end)[1]);
            contour.push_back((*end)[0]);
            return;
        }
    const bool is_square = rule_in == CornerRule::square || rule_out == CornerRule::square;
    add_mitre(contour, corner, (is_square ? 1 : mitre_limit) * std::max(reach_in, reach_out));
}

Vec2 way_of(const Points2& line, bool at_end) {
    const Eigen::Index last = line.rows() - 1;
    for (Eigen::Index i = 0; i < last; ++i) {
        const Eigen::Index k = at_end ? last - 1 - i : i;
        const Vec2 way = line.row(k + 1) - line.row(k);
        if (way.norm() >= same_point) return way.normalized();
    }
    return Vec2::Zero();
}

}  // namespace

Points2 make_cut_line(const std::vector<AllowedEdge>& edges) {
    std::vector<Vec2> contour;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        add_edge(contour, edges[e]);
        const AllowedEdge& next = edges[(e + 1) % edges.size()];
        const Corner corner{next.sew_line.row(0), way_of(edges[e].sew_line, true), way_of(next.sew_line, false),
                            edges[e].allowance, next.allowance};
        add_corner(contour, corner, edges[e].corner, next.corner);
    }
    return outside_of(contour);
}

}  // namespace ripstop
