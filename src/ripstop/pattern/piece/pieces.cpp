#include "ripstop/pattern/piece/pieces.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/annotation.h"
#include "ripstop/pattern/piece/count_patterns.h"
#include "ripstop/pattern/piece/drawn_lines.h"
#include "ripstop/pattern/piece/edge_labels.h"
#include "ripstop/pattern/piece/outline.h"

namespace ripstop {
namespace {

/// The fallback: an arrow across the pole, inside the inscribed circle and within six tenths of the width.
Points2 grain_line_at_pole(const Points2& outline, const Circle& room) {
    double half = 0.5 * room.radius;
    for (const auto& chord : horizontal_chords(outline, room.centre.y()))
        if (chord[0] <= room.centre.x() && room.centre.x() <= chord[1])
            half = std::min({half, 0.3 * (chord[1] - chord[0])});
    Points2 line(2, 2);
    line << room.centre.x() - half, room.centre.y(), room.centre.x() + half, room.centre.y();
    return line;
}

/// The digits after a letter in a name such as G03P07: those of the gore (`letter` 0) or the row (1); empty for
/// other names.
std::string number_in_name(const std::string& name, int letter) {
    std::string found[2];
    std::size_t at = 0;
    for (std::string& digits : found) {
        if (at >= name.size() || !std::isalpha(static_cast<unsigned char>(name[at]))) return "";
        for (++at; at < name.size() && std::isdigit(static_cast<unsigned char>(name[at])); ++at) digits += name[at];
        if (digits.empty()) return "";
    }
    return at == name.size() ? found[letter] : "";
}

/// The first of these attributes that the tile has.
std::string attribute(const Tile& tile, std::initializer_list<const char*> keys) {
    for (const char* key : keys)
        if (const auto found = tile.attributes.find(key); found != tile.attributes.end()) return found->second;
    return "";
}

void name_piece(PatternPiece& piece, const CutPlan& plan, const Tile& tile, const PieceOptions& options) {
    piece.name = tile.name;
    piece.gore = attribute(tile, {"gore"});
    piece.row = attribute(tile, {"row", "panel"});
    if (piece.gore.empty()) piece.gore = number_in_name(tile.name, 0);
    if (piece.row.empty()) piece.row = number_in_name(tile.name, 1);
    piece.colour = colour_of(tile);
    piece.fabric = plan.fabric_of(tile).name;
    piece.revision = options.revision;
}

/// The lines below the name; what the sewing table needs comes first.
std::vector<std::string> notes_of(const PatternPiece& piece) {
    std::vector<std::string> notes{"WARP"};
    if (const std::string count = cut_count(piece); !count.empty()) notes.push_back(count);
    if (!piece.gore.empty() && !piece.row.empty()) notes.push_back("gore " + piece.gore + " row " + piece.row);
    if (!piece.revision.empty()) notes.push_back("rev " + piece.revision);
    return notes;
}

CutLine cut_line(const PatternPiece& piece, CornerRule corners) {
    std::vector<AllowedEdge> edges;
    double widest = 0;
    for (std::size_t e = 0; e < piece.edges.size(); ++e) {
        const PieceEdge& edge = piece.edges[e];
        // an edge shorter than its allowance cannot be folded back
        const CornerRule rule = !edge.mates.empty()             ? corners
                                : edge.length >= edge.allowance ? CornerRule::hem
                                                                : CornerRule::mitre;
        edges.push_back({piece.edge_line(e), edge.allowance, rule});
        widest = std::max(widest, piece.edges[e].allowance);
    }
    return widest > 0 ? make_cut_line(edges) : CutLine{piece.sew_line};
}

/// Where allowances meet, a notch also starts at the cut line, and is shallower.
void shorten_notches(PatternPiece& piece) {
    constexpr double start = 0.05 * millimetre;  // the cut line lies inside the sew line where that touches itself
    for (PieceNotch& notch : piece.notches) {
        const auto is_its = [&notch](const MetAllowances& met) {
            return met.edge == notch.edge || met.mate_edge == notch.edge;
        };
        if (std::none_of(piece.met.begin(), piece.met.end(), is_its)) continue;
        const double reach =
            distance_along(piece.cut_line, notch.on_sew - start * notch.outward, notch.outward) - start;
        if (!(reach < notch.reach)) continue;
        notch.depth *= std::max(0.0, reach) / notch.reach;
        notch.reach = std::max(0.0, reach);
    }
}

/// Without allowance a notch cannot be cut, so it is drawn, from the sew line inwards.
void draw_uncut_notches(PatternPiece& piece) {
    constexpr double stroke = 3 * millimetre;
    for (const PieceNotch& notch : piece.notches) {
        if (notch.depth > 0) continue;
        for (const auto& [from, to] : notch.strokes(notch.on_sew, stroke)) {
            DrawnLine line{"match mark " + notch.seam, Points2(2, 2)};
            line.points.row(0) = from;
            line.points.row(1) = to;
            piece.lines.push_back(std::move(line));
        }
    }
}

/// Adds label, grain arrow and the neighbours' names.
void write_on(PatternPiece& piece) {
    // The radius is at least area over perimeter, so this is a tenth of it or better. The floor is for outlines
    // without inside, which failed flattenings have.
    const Vec2 size = piece.sew_line.colwise().maxCoeff() - piece.sew_line.colwise().minCoeff();
    const double precision =
        std::max(1e-4 * size.maxCoeff(), 0.1 * signed_area(piece.sew_line) / perimeter(piece.sew_line));
    const Circle room = largest_circle_inside(piece.sew_line, precision);
    // Two fifths of the circle's radius leave room for the arrow above or below; the height is reduced if that is
    // not enough.
    double largest = std::clamp(0.4 * room.radius, 0.003, 0.040);
    Box label_box;
    for (int attempt = 0; attempt < 3; ++attempt, largest /= 2) {
        LabelPlace label = place_label(piece.sew_line, room, piece.name, notes_of(piece), largest);
        piece.labels = std::move(label.labels);
        label_box = label.box;
        piece.grain_line = place_grain_line(piece.sew_line, room, label.box);
        if (piece.grain_line.rows() == 2 && piece.grain_line(1, 0) - piece.grain_line(0, 0) >= 0.5 * room.radius) break;
    }
    for (std::size_t i = 1; i < piece.labels.size(); ++i)  // the first label is the name
        piece.labels[i].counts = piece.labels[i].text == cut_count(piece);
    if (piece.grain_line.rows() != 2) piece.grain_line = grain_line_at_pole(piece.sew_line, room);
    const Vec2 tail = piece.grain_line.row(0), head = piece.grain_line.row(1);
    const double length = (head - tail).norm();
    const Box arrow{(tail + head) / 2, {length / 2, arrow_half_width(length)}, 0};
    for (Label& label : place_edge_labels(piece, {label_box, arrow})) piece.labels.push_back(std::move(label));
}

}  // namespace

std::string colour_of(const Tile& tile) {
    return attribute(tile, {"colour", "color", "material"});
}

std::vector<PatternPiece> make_pieces(const CutPlan& plan, const PieceOptions& options, int threads) {
    const std::vector<PieceOutline> outlines = make_outlines(plan, options.chord_error);
    const std::vector<std::vector<PieceNotch>> notches = make_notches(plan, outlines, options.notches);
    const std::vector<Quantity> quantity = quantities(plan);
    std::vector<PatternPiece> all(plan.tiles.size());
    parallel_for(static_cast<int>(plan.tiles.size()), threads, [&](int t) {
        const auto i = static_cast<std::size_t>(t);
        if (!plan.tiles[i].is_flat()) return;
        PatternPiece& piece = all[i];
        name_piece(piece, plan, plan.tiles[i].tile, options);
        piece.quantity = quantity[i].same;
        piece.quantity_mirrored = quantity[i].mirrored;
        if (const int first = plan.tiles[i].equal_to; first >= 0) {
            piece.pattern = plan.tiles[at(first)].tile.name;
            piece.mirrored = plan.tiles[i].mirrored;
        }
        piece.sew_line = outlines[i].sew_line;
        piece.edges = outlines[i].edges;
        CutLine cut = cut_line(piece, options.corners);
        piece.cut_line = std::move(cut.points);
        piece.met = std::move(cut.met);
        piece.notches = notches[i];
        shorten_notches(piece);
        piece.lines = draw_lines(plan.tiles[i], options.chord_error);
        draw_uncut_notches(piece);
        write_on(piece);
    });
    std::vector<PatternPiece> pieces;
    for (PatternPiece& piece : all)
        if (piece.sew_line.rows() > 0) pieces.push_back(std::move(piece));
    return pieces;
}

}  // namespace ripstop
