#include "ripstop/pattern/cut/cut_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/pattern/cut/outline_relation.h"
#include "ripstop/pattern/cut/sew_contour.h"

namespace ripstop {
namespace {

constexpr double check_tolerance = 0.06 * millimetre;
constexpr double sparsest_checked = 20 * millimetre;  // between places
constexpr double least_left = 1 * millimetre;         // less cloth cannot be sewn

std::string short_millimetres(double metres) {
    std::string text = format_fixed(metres / millimetre, 1);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return text;
}

std::string edge_text(const PatternPiece& piece, int edge) {
    const std::string& type = piece.edges[at(edge)].seam_type;
    return fmt::format("edge {}{}", edge + 1, type.empty() ? "" : " (" + type + ")");
}

std::vector<AllowedEdge> edges_of(const PatternPiece& piece) {
    std::vector<AllowedEdge> edges;
    for (std::size_t e = 0; e < piece.edges.size(); ++e)
        edges.push_back({piece.edge_line(e), piece.edges[e].allowance, CornerRule::mitre});
    return edges;
}

/// What is wrong along an edge: where the cut line is too near, or missing.
struct Breach {
    double length = 0;
    double nearest = std::numeric_limits<double>::infinity();  ///< smallest distance of the cut line [m]
    Vec2 at = Vec2::Zero();
};

class CutChecker {
  public:
    explicit CutChecker(const PatternPiece& piece)
        : piece_(piece), contour_(edges_of(piece)), sew_(piece.sew_line), cut_(piece.cut_line) {}

    std::vector<CutFault> run() {
        check_line();
        check_inside();
        for (std::size_t i = 0; i < contour_.segments().size(); ++i) check_segment(i);
        for (const auto& [edge, breach] : narrow_)
            add(fmt::format("{} has an allowance of {} mm instead of {} mm, over {} mm", edge_text(piece_, edge),
                            short_millimetres(std::max(0.0, breach.nearest)), short_millimetres(allowance(edge)),
                            short_millimetres(breach.length)),
                breach);
        for (const auto& [edge, breach] : lost_)
            add(fmt::format("{} is not cut over {} mm: another allowance covers what lies beyond it",
                            edge_text(piece_, edge), short_millimetres(breach.length)),
                breach);
        return std::move(faults_);
    }

  private:
    void add(const std::string& message, const Breach& breach) {
        faults_.push_back({message, breach.at, breach.length / millimetre});
    }
    double allowance(int edge) const { return piece_.edges[static_cast<std::size_t>(edge)].allowance; }

    void check_line() {
        const SelfIntersections crossings = self_intersections(piece_.cut_line);
        if (crossings.count > 0) faults_.push_back({"the cut line meets itself", crossings.first, 0});
        if (!(signed_area(piece_.cut_line) > 0))
            faults_.push_back({"the cut line runs clockwise", piece_.cut_line.row(0), 0});
    }

    void check_inside() {
        CutFault uncut{"the sew line leaves the cut line"}, cut{"the cut line crosses the sew line"};
        const auto look = [](const IndexedOutline& points, const IndexedOutline& outline, bool inside,
                             CutFault& fault) {
            for (Eigen::Index i = 0; i < points.points().rows(); ++i) {
                const Vec2 at = points.corner(i);
                if (outline.contains(at) == inside || outline.is_near(at, check_tolerance)) continue;
                const double distance = outline.distance(at) / millimetre;
                if (distance > fault.value) fault = {fault.message, at, distance};
            }
        };
        look(sew_, cut_, true, uncut);
        look(cut_, sew_, false, cut);
        for (const CutFault& fault : {uncut, cut})
            if (fault.value > 0)
                faults_.push_back(
                    {fmt::format("{} by {} mm", fault.message, format_fixed(fault.value, 1)), fault.at, fault.value});
    }

    void check_segment(std::size_t index) {
        const SewSegment& segment = contour_.segments()[index];
        const double spacing =
            segment.allowance > 0 ? std::min(segment.allowance / 2, sparsest_checked) : sparsest_checked;
        const int places = std::max(1, static_cast<int>(std::ceil(segment.length / spacing)));
        for (int k = 0; k < places; ++k)
            check_place({index, segment.length * (k + 0.5) / places}, segment.length / places);
    }

    void check_place(const SewPlace& place, double length) {
        const SewSegment& segment = contour_.segments()[place.segment];
        const Vec2 at = segment.at(place.along), end = at + segment.allowance * segment.outward;
        if (cut_.is_near(end, check_tolerance)) return;
        const double reach =
            distance_along(piece_.cut_line, at - check_tolerance * segment.outward, segment.outward) - check_tolerance;
        if (reach < segment.allowance) {
            if (may_be_narrow(place, reach)) return;
            record(narrow_[segment.edge], at, length, reach);
        } else if (is_covered(place, end, true) && !is_covered(place, end, false)) {
            record(lost_[segment.edge], at, length, reach);
        }
    }

    static void record(Breach& breach, const Vec2& at, double length, double reach) {
        breach.length += length;
        if (!(reach < breach.nearest)) return;
        breach.nearest = reach;
        breach.at = at;
    }

    bool may_be_narrow(const SewPlace& place, double reach) const {
        const SewSegment& segment = contour_.segments()[place.segment];
        for (const MetAllowances& met : piece_.met)
            if ((met.edge == segment.edge || met.mate_edge == segment.edge) && reach >= met.left - check_tolerance)
                return true;
        const std::size_t count = piece_.edges.size(), e = static_cast<std::size_t>(segment.edge);
        const double widest = std::max({segment.allowance, piece_.edges[(e + 1) % count].allowance,
                                        piece_.edges[(e + count - 1) % count].allowance});
        const Points2 line = piece_.edge_line(e);
        const Vec2 at = segment.at(place.along);
        return std::min((at - Vec2(line.row(0))).norm(), (at - Vec2(line.row(line.rows() - 1))).norm()) <=
               furthest_corner * widest;
    }

    /// True if the allowance of another part covers the point. `from_apart` chooses between parts that are apart
    /// from `place` and parts that are not.
    bool is_covered(const SewPlace& place, const Vec2& point, bool from_apart) const {
        for (std::size_t i = 0; i < contour_.segments().size(); ++i) {
            const SewSegment& other = contour_.segments()[i];
            if (i == place.segment) continue;
            const double along = std::clamp((point - other.from).dot(other.way), 0.0, other.length);
            if ((point - other.at(along)).norm() < other.allowance - check_tolerance &&
                contour_.is_apart(place, {i, along}) == from_apart)
                return true;
        }
        return false;
    }

    const PatternPiece& piece_;
    SewContour contour_;
    IndexedOutline sew_, cut_;
    std::map<int, Breach> narrow_, lost_;  // by edge
    std::vector<CutFault> faults_;
};

/// The place in space that corresponds to a place on the piece, on the nearest boundary edge.
Vec3 in_space(const FlatTile& flat, const Vec2& at) {
    const std::vector<int>& loop = flat.tile.boundary;
    double best = std::numeric_limits<double>::infinity();
    Vec3 found = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const int from = loop[i], to = loop[(i + 1) % loop.size()];
        const Vec2 start = flat.flattening.positions.row(from), way = Vec2(flat.flattening.positions.row(to)) - start;
        const double length = way.squaredNorm();
        const double share = length > 0 ? std::clamp((at - start).dot(way) / length, 0.0, 1.0) : 0.0;
        const double distance = (start + share * way - at).squaredNorm();
        if (!(distance < best)) continue;
        best = distance;
        const auto& positions = flat.tile.mesh.positions;
        found = (1 - share) * Vec3(positions.row(from)) + share * Vec3(positions.row(to));
    }
    return found;
}

bool has_no_outline(const FlatTile& tile) {
    constexpr std::array codes{"flipped", "outline", "overlap"};
    const auto& findings = tile.verdict.findings;
    return !tile.flattening.summary.usable() ||
           std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
               return std::any_of(codes.begin(), codes.end(), [&](const char* code) { return finding.code == code; });
           });
}

std::vector<std::string> judge_piece(FlatTile& tile, const PatternPiece& piece, bool allowance_fit) {
    std::vector<std::string> notes;
    std::vector<Finding>& findings = tile.verdict.findings;
    for (const CutFault& fault : check_cut_line(piece))
        findings.push_back({"cut_line", fault.message, in_space(tile, fault.at), fault.value, 0});
    for (const MetAllowances& met : piece.met) {
        const std::string text = met_text(piece, met) + "; the cut line runs between them and leaves ";
        const std::string left = short_millimetres(std::max(0.0, met.left)) + " mm";
        if (allowance_fit && met.left >= least_left) {
            if (piece.pattern.empty()) notes.push_back(piece.name + ": " + text + left);
            continue;
        }
        const double both = piece.edges[at(met.edge)].allowance + piece.edges[at(met.mate_edge)].allowance;
        findings.push_back(
            {"allowances_meet",
             text + (met.left < least_left
                         ? "nothing to sew: widen the gap"
                         : left + ": widen the gap, reduce the allowances, or accept this with --allowance-fit"),
             in_space(tile, met.at), met.gap / millimetre, both / millimetre});
    }
    return notes;
}

std::vector<std::string> joined(const std::vector<std::vector<std::string>>& lists) {
    std::vector<std::string> all;
    for (const std::vector<std::string>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace

std::vector<CutFault> check_cut_line(const PatternPiece& piece) {
    const bool is_allowed =
        std::any_of(piece.edges.begin(), piece.edges.end(), [](const PieceEdge& edge) { return edge.allowance > 0; });
    if (!is_allowed || piece.cut_line.rows() == 0) return {};
    return CutChecker(piece).run();
}

std::string met_text(const PatternPiece& piece, const MetAllowances& met) {
    const auto allowed = [&piece](int edge) { return short_millimetres(piece.edges[at(edge)].allowance); };
    const std::string edges = met.edge == met.mate_edge
                                  ? "two parts of " + edge_text(piece, met.edge)
                                  : edge_text(piece, met.edge) + " and " + edge_text(piece, met.mate_edge);
    return fmt::format("the allowances of {} overlap over {} mm: {} + {} mm in a gap of {} mm", edges,
                       short_millimetres(met.length), allowed(met.edge), allowed(met.mate_edge),
                       short_millimetres(met.gap));
}

std::vector<std::string> judge_cut_lines(CutPlan& plan, const std::vector<PatternPiece>& pieces, bool allowance_fit,
                                         int threads) {
    std::map<std::string, const PatternPiece*> named;
    for (const PatternPiece& piece : pieces) named[piece.name] = &piece;
    std::vector<std::vector<std::string>> notes(plan.tiles.size());
    parallel_for(static_cast<int>(plan.tiles.size()), threads, [&](int t) {
        const auto i = static_cast<std::size_t>(t);
        const auto piece = named.find(plan.tiles[i].tile.name);
        if (piece != named.end() && !has_no_outline(plan.tiles[i]))
            notes[i] = judge_piece(plan.tiles[i], *piece->second, allowance_fit);
    });
    return joined(notes);
}

std::vector<std::string> cut_line_faults(const std::vector<PatternPiece>& pieces, int threads) {
    std::vector<std::vector<std::string>> faults(pieces.size());
    parallel_for(static_cast<int>(pieces.size()), threads, [&](int p) {
        const auto i = static_cast<std::size_t>(p);
        for (const CutFault& fault : check_cut_line(pieces[i]))
            faults[i].push_back(fmt::format("{}: {}, at ({}, {}) mm", pieces[i].name, fault.message,
                                            short_millimetres(fault.at.x()), short_millimetres(fault.at.y())));
    });
    return joined(faults);
}

}  // namespace ripstop
