#include "ripstop/pattern/revision/compare_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/revision/compare_edges.h"
#include "ripstop/pattern/revision/fit_outline.h"

namespace ripstop {
namespace {

/// The angle from the warp to the direction of the grain arrow [rad].
double grain_angle(const PatternPiece& piece) {
    const Vec2 way = piece.grain_line.row(1) - piece.grain_line.row(0);
    return std::atan2(way.y(), way.x());
}

std::string grain_text(const PatternPiece& piece) {
    if (piece.grain_line.rows() != 2) return "";
    const std::string text = format_fixed(grain_angle(piece) / degree, 3);
    return text == "-0.000" ? "0.000" : text == "-180.000" ? "180.000" : text;
}

bool has_same_grain(const PatternPiece& a, const PatternPiece& b, double tolerance) {
    if (a.grain_line.rows() != 2 || b.grain_line.rows() != 2) return a.grain_line.rows() == b.grain_line.rows();
    const double turn = std::remainder(grain_angle(b) - grain_angle(a), 2 * std::numbers::pi);
    return std::abs(turn) * (a.grain_line.row(1) - a.grain_line.row(0)).norm() / 2 <= tolerance;
}

std::vector<FieldChange> compare_fields(const PatternPiece& a, const PatternPiece& b, double tolerance) {
    std::vector<FieldChange> changes;
    const auto compare = [&changes](const char* field, const std::string& before, const std::string& after) {
        if (before != after) changes.push_back({field, before, after});
    };
    compare("fabric", a.fabric, b.fabric);
    compare("colour", a.colour, b.colour);
    compare("quantity", std::to_string(a.quantity), std::to_string(b.quantity));
    compare("quantity_mirrored", std::to_string(a.quantity_mirrored), std::to_string(b.quantity_mirrored));
    if (!has_same_grain(a, b, tolerance)) compare("grain_line_deg", grain_text(a), grain_text(b));
    return changes;
}

bool is_point_by_point(const Points2& a, const Points2& b, double tolerance) {
    return a.rows() == b.rows() && (a - b).rowwise().norm().maxCoeff() <= tolerance;
}

/// Matches each line with the nearest of the same name.
std::vector<LineChange> compare_lines(const PatternPiece& a, const PatternPiece& b, const OutlineFit& motion,
                                      double tolerance) {
    std::vector<const DrawnLine*> there;
    for (const DrawnLine& line : b.lines)
        if (line.points.rows() > 0) there.push_back(&line);
    std::vector<DrawnLine> others;
    for (const DrawnLine& line : a.lines) {
        if (line.points.rows() == 0) continue;
        const DrawnLine moved{line.name, motion.moved(line.points)};
        const auto same = std::find_if(there.begin(), there.end(), [&](const DrawnLine* other) {
            return other->name == moved.name && is_point_by_point(moved.points, other->points, tolerance);
        });
        if (same == there.end())
            others.push_back(moved);
        else
            there.erase(same);
    }
    std::vector<LineChange> changes;
    for (const DrawnLine& line : others) {
        auto nearest = there.end();
        double least = 0;
        for (auto other = there.begin(); other != there.end(); ++other) {
            if ((*other)->name != line.name) continue;
            const double distance = line_distance(line.points, (*other)->points);
            if (nearest != there.end() && distance >= least) continue;
            nearest = other;
            least = distance;
        }
        if (nearest == there.end()) {
            changes.push_back({line.name, LineChange::Kind::gone});
            continue;
        }
        if (least > tolerance) changes.push_back({line.name, LineChange::Kind::moved, least});
        there.erase(nearest);
    }
    for (const DrawnLine* line : there) changes.push_back({line->name, LineChange::Kind::added});
    return changes;
}

bool has_same_outline(const PatternPiece& a, const PatternPiece& b) {
    return a.outline().rows() == b.outline().rows() && a.outline() == b.outline();
}

/// Sets the measurements of a piece in one revision.
void measure(const PatternPiece& piece, double& area, double& length, int& edges) {
    area = piece.outline().rows() < 3 ? 0 : signed_area(piece.outline());
    length = piece.sew_line.rows() < 2 ? 0 : perimeter(piece.sew_line);
    edges = static_cast<int>(piece.edges.size());
}

PieceChange compare(const PatternPiece& a, const PatternPiece& b, double tolerance) {
    PieceChange change{a.name};
    measure(a, change.area_before, change.perimeter_before, change.edges_before);
    measure(b, change.area_after, change.perimeter_after, change.edges_after);
    const bool is_cut = a.outline().rows() >= 3 && b.outline().rows() >= 3;
    OutlineFit motion;
    if (is_cut && !has_same_outline(a, b)) {
        change.distance = outline_distance(a.outline(), b.outline());
        const OutlineFit fit = fit_outline(a.outline(), b.outline());
        change.distance_fitted = std::min(fit.distance, change.distance);
        if (fit.distance < change.distance) motion = fit;
        change.grain_turn = 0 - motion.turn;
    }
    if (is_cut && a.sew_line.rows() >= 3 && b.sew_line.rows() >= 3)
        change.sew_distance_fitted = outline_distance(motion.moved(a.sew_line), b.sew_line);
    change.edges = compare_edges(a, b, motion, tolerance);
    change.lines = compare_lines(a, b, motion, tolerance);
    change.fields = compare_fields(a, b, tolerance);
    return change;
}

bool is_change(const PieceChange& change, const PatternPiece& piece, double tolerance) {
    const double size = piece.outline().rows() > 0 ? (piece.upper() - piece.lower()).norm() / 2 : 1;
    return change.edges_before != change.edges_after || !change.edges.empty() || !change.fields.empty() ||
           !change.lines.empty() || change.sew_distance_fitted > tolerance ||
           std::abs(change.area_after - change.area_before) > tolerance * change.perimeter_before ||
           std::abs(change.perimeter_after - change.perimeter_before) > tolerance ||
           change.distance_fitted > tolerance || std::abs(change.grain_turn) * size > tolerance;
}

}  // namespace

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

std::vector<SeamTypeChange> compare_seam_types(const PieceSet& before, const PieceSet& after, double tolerance) {
    std::vector<SeamTypeChange> changes;
    for (const SeamType& a : before.seam_types)
        for (const SeamType& b : after.seam_types) {
            if (a.name != b.name) continue;
            SeamTypeChange change{a.name, {}};
            if (std::abs(b.allowance - a.allowance) > tolerance)
                change.fields.push_back({"allowance_mm", format_shortest(a.allowance / millimetre),
                                         format_shortest(b.allowance / millimetre)});
            if (a.rows != b.rows) change.fields.push_back({"rows", std::to_string(a.rows), std::to_string(b.rows)});
            if (a.tape != b.tape)
                change.fields.push_back({"tape", a.tape ? "true" : "false", b.tape ? "true" : "false"});
            if (!change.fields.empty()) changes.push_back(change);
        }
    return changes;
}

}  // namespace ripstop
