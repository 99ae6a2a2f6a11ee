#include "ripstop/io/dxf/dxf_blocks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/corners.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/version.h"

namespace ripstop {
namespace {

namespace layer {
constexpr const char *boundary = "1", *turn_point = "2", *curve_point = "3", *notch = "4", *grain_copy = "5",
                     *grain = "7", *internal = "8", *sew = "14", *annotation = "15";
}

constexpr const char* size_name = "ONE";             // patterns of an envelope have one size
constexpr double system_height = 0.25 * millimetre;  // of texts that programs read and people do not
constexpr double sampled_turn = 15 * degree;         // a finely sampled curve turns by less than this at each point
constexpr std::size_t longest_symbol = 31;           // of Release 12

/// `key: value` in the dialect's spelling.
std::string entry(const DxfDialect& dialect, std::string key, const std::string& value) {
    if (dialect.upper_case_keys)
        std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::toupper(c); });
    return key + ": " + value;
}

/// Replaces all characters except [A-Z0-9_], which every reader accepts.
std::string symbol_letters(const std::string& name) {
    std::string symbol;
    for (const char c : ascii_text(name)) {
        const bool is_lower = c >= 'a' && c <= 'z', is_kept = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        symbol += is_lower ? static_cast<char>(c - 'a' + 'A') : is_kept ? c : '_';
    }
    return symbol.empty() ? "PIECE" : symbol;
}

/// A unique block name: PIECE_SIZE, at most 31 letters.
std::string block_name(const std::string& name, std::set<std::string>& used) {
    const std::string stem = symbol_letters(name), size = std::string("_") + size_name;
    for (int n = 1;; ++n) {
        const std::string end = (n == 1 ? "" : "_" + std::to_string(n)) + size;
        std::string symbol = stem.substr(0, longest_symbol - end.size()) + end;
        if (used.insert(symbol).second) return symbol;
    }
}

/// A contour and the points at which its edges begin; none if it has no corner.
struct Contour {
    const char* layer;
    const Points2& points;
    std::vector<int> corners;
};

Contour sew_contour(const PatternPiece& piece) {
    Contour contour{layer::sew, piece.sew_line, {}};
    if (piece.edges.size() > 1)
        for (const PieceEdge& edge : piece.edges) contour.corners.push_back(edge.first);
    return contour;
}

/// The contour of the cut line. It has corners that the sew line lacks, where an allowance ends.
Contour boundary(const PatternPiece& piece) {
    const Points2& points = piece.outline();
    const bool is_sewn = points.rows() == piece.sew_line.rows() && points == piece.sew_line;
    if (is_sewn && piece.edges.size() > 1) return {layer::boundary, points, sew_contour(piece).corners};
    return {layer::boundary, points, sharp_corners(points, sampled_turn)};
}

void draw_contour(DxfEntities& out, const DxfDialect& dialect, const Contour& contour) {
    const Eigen::Index count = contour.points.rows();
    if (dialect.closed_contours || contour.corners.empty()) {
        out.polyline(contour.layer, contour.points, true);
        return;
    }
    for (std::size_t c = 0; c < contour.corners.size(); ++c) {
        const Eigen::Index first = contour.corners[c];
        const Eigen::Index steps = (contour.corners[(c + 1) % contour.corners.size()] - first + count - 1) % count + 1;
        Points2 edge(steps + 1, 2);
        for (Eigen::Index i = 0; i <= steps; ++i) edge.row(i) = contour.points.row((first + i) % count);
        out.polyline(contour.layer, edge, false);
    }
}

void draw_points(DxfEntities& out, const Contour& contour) {
    std::size_t next = 0;
    for (Eigen::Index i = 0; i < contour.points.rows(); ++i) {
        const bool is_corner = next < contour.corners.size() && contour.corners[next] == i;
        next += is_corner;
        out.entity("POINT", is_corner ? layer::turn_point : layer::curve_point);
        out.point(10, contour.points.row(i));
    }
}

/// Draws the notches. Their angle points into the piece, counter-clockwise from +x.
void draw_notches(DxfEntities& out, const DxfDialect& dialect, const PatternPiece& piece) {
    using NotchMark = DxfDialect::NotchMark;
    if (dialect.notch == NotchMark::line) return draw_slits(out, layer::notch, piece);
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [at, end] : notch.slits()) {
            out.entity("POINT", layer::notch);
            out.number(10, at.x());
            out.number(20, at.y());
            out.number(30, dialect.notch == NotchMark::sized_point ? dialect.depth_sign * notch.depth : 0);
            if (dialect.notch_width > 0) out.number(39, dialect.notch_width);
            const double angle = std::atan2(-notch.outward.y(), -notch.outward.x()) / degree;
            out.pair(50, format_fixed(angle < 0 ? angle + 360 : angle, 4));
        }
}

std::string quantity(const DxfDialect& dialect, const PatternPiece& piece) {
    if (dialect.counts_mirrored) return std::to_string(piece.quantity) + "," + std::to_string(piece.quantity_mirrored);
    return std::to_string(piece.quantity + piece.quantity_mirrored);
}

/// A note on the piece where its count alone would mislead.
std::string annotation(const DxfDialect& dialect, const PatternPiece& piece) {
    if (piece.quantity + piece.quantity_mirrored == 0) return "cut by the pattern of an equal piece";
    if (dialect.counts_mirrored || piece.quantity_mirrored == 0) return "";
    return std::to_string(piece.quantity) + " as drawn and " + std::to_string(piece.quantity_mirrored) + " mirrored";
}

void write_piece_texts(DxfEntities& out, const DxfDialect& dialect, const PatternPiece& piece) {
    const Points2& outline = piece.outline();
    Vec2 at = piece.labels.empty() ? Vec2(outline.colwise().mean()) : piece.labels.front().middle;
    const auto write = [&](const char* key, const std::string& value) {
        if (value.empty()) return;
        out.text_at(layer::boundary, entry(dialect, key, value), at, system_height);
        at.y() -= 2 * system_height;
    };
    write("Piece Name", piece.name.empty() ? symbol_letters(piece.name) : piece.name);
    write("SIZE", size_name);
    write("Quantity", quantity(dialect, piece));
    write("ANNOTATION", annotation(dialect, piece));
    write("CATEGORY", piece.row);
    write("Fabric", piece.fabric);
}

void write_block(DxfEntities& out, const DxfDialect& dialect, const PatternPiece& piece, const std::string& name) {
    out.entity("BLOCK", dialect.block_layer);
    out.pair(2, name);
    out.pair(70, 64);
    out.point(10, Vec2::Zero());
    std::vector<Contour> contours{boundary(piece)};
    const Points2& cut = contours.front().points;
    if (cut.rows() != piece.sew_line.rows() || cut != piece.sew_line) contours.push_back(sew_contour(piece));
    for (const Contour& contour : contours) draw_contour(out, dialect, contour);
    for (const Contour& contour : contours) draw_points(out, contour);
    draw_notches(out, dialect, piece);
    if (piece.grain_line.rows() == 2) {
        out.line(layer::grain, piece.grain_line.row(0), piece.grain_line.row(1));
        if (dialect.copies_grain) out.line(layer::grain_copy, piece.grain_line.row(0), piece.grain_line.row(1));
    }
    for (const DrawnLine& line : piece.lines) out.polyline(layer::internal, line.points, false);
    write_piece_texts(out, dialect, piece);
    for (const Label& label : piece.labels) out.text(layer::annotation, label);
    out.entity("ENDBLK", dialect.block_layer);
}

/// A date, given as YYYY-MM-DD, in the dialect's format.
std::string date_text(const DxfDialect& dialect, const std::string& date) {
    if (date.size() != 10) return "";
    const std::string year = date.substr(0, 4), month = date.substr(5, 2), day = date.substr(8, 2);
    return (dialect.day_first ? day + "-" + month : month + "-" + day) + "-" + year;
}

void write_style_texts(DxfEntities& out, const DxfDialect& dialect, Vec2 at, const DxfOptions& options) {
    const auto write = [&](const std::string& text) {
        at.y() -= 2 * system_height;
        out.text_at(layer::boundary, text, at, system_height);
    };
    const auto write_entry = [&](const char* key, const std::string& value) {
        if (!value.empty()) write(entry(dialect, key, value));
    };
    if (!dialect.standard.empty()) write(dialect.standard);
    const std::string style = options.style.empty() ? "envelope" : options.style;
    write_entry("Style Name", options.revision.empty() ? style : style + " rev " + options.revision);
    write_entry("Creation Date", date_text(dialect, options.date));
    if (dialect.packs_author) {
        write_entry("Author", std::string("Ripstop ; ripstop ; ") + version);
    } else {
        write_entry("Author", "Ripstop");
        write_entry("PRODUCT", "ripstop");
        write_entry("VERSION", version);
    }
    write_entry("Sample Size", size_name);
    write_entry("Units", "METRIC");
}

}  // namespace

std::vector<DxfLayer> numbered_layers() {
    return {{layer::boundary, 1}, {layer::turn_point, 2}, {layer::curve_point, 8},
            {layer::notch, 6},    {layer::grain_copy, 9}, {layer::grain, 5},
            {layer::internal, 4}, {layer::sew, 3},        {layer::annotation, 7}};
}

void write_blocks(DxfEntities& out, const DxfDialect& dialect, const std::vector<PatternPiece>& placed_pieces,
                  const Vec2& corner, const DxfOptions& options) {
    std::set<std::string> used;
    std::vector<std::string> names;
    out.begin("BLOCKS");
    for (const PatternPiece& piece : placed_pieces) {
        names.push_back(block_name(piece.name, used));
        write_block(out, dialect, piece, names.back());
    }
    out.end();
    out.begin("ENTITIES");
    for (const std::string& name : names) {
        out.entity("INSERT", layer::boundary);
        out.pair(2, name);
        out.point(10, Vec2::Zero());
    }
    write_style_texts(out, dialect, corner, options);
    out.end();
}

}  // namespace ripstop
