#include "ripstop/io/svg/svg.h"

#include <ostream>
#include <set>
#include <sstream>
#include <string>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/io/text/sheet.h"

namespace ripstop {
namespace {

constexpr double margin = 0.01;

/// Converts metres on the cloth, y up, to millimetres from the drawing's upper left corner, y down.
class Page {
  public:
    explicit Page(const Sheet& sheet) : left_(sheet.lower.x() - margin), top_(sheet.upper.y() + margin) {}
    std::string x(const Vec2& p) const { return format_fixed((p.x() - left_) / millimetre, 3); }
    std::string y(const Vec2& p) const { return format_fixed((top_ - p.y()) / millimetre, 3); }
    std::string at(const Vec2& p) const { return x(p) + ' ' + y(p); }

  private:
    double left_, top_;
};

std::string open_path(const Page& page, const Points2& points, const Vec2& shift) {
    std::string path;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        path += (i == 0 ? "M" : " L") + page.at(Vec2(points.row(i)) + shift);
    return path;
}

std::string closed_path(const Page& page, const Points2& corners, const Vec2& shift) {
    return open_path(page, corners, shift) + " Z";
}

/// SVG places letters by their baseline and sizes them by the em; capitals are about 0.72 em high.
std::string text(const Page& page, const Label& label, const Vec2& shift, const char* colour) {
    const Vec2 middle = label.middle + shift;
    const double height = label.height / millimetre;
    std::string result = "<text fill=\"" + std::string(colour) + "\" transform=\"translate(" + page.at(middle) + ")";
    if (label.turn != 0) result += " rotate(" + format_fixed(-label.turn / degree, 3) + ")";
    result += "\" y=\"" + format_fixed(height / 2, 3) + "\" font-size=\"" + format_fixed(height / 0.72, 3) + "\">";
    return result + xml_text(label.text) + "</text>\n";
}

/// A unique id, already escaped.
std::string unused_id(const std::string& name, std::set<std::string>& used) {
    std::string base;
    for (const char c : xml_text(name)) base += c == ' ' || c == '\t' || c == '\n' || c == '\r' ? '_' : c;
    if (base.empty()) base = "piece";
    std::string id = base;
    for (int n = 2; !used.insert(id).second; ++n) id = base + "-" + std::to_string(n);
    return id;
}

/// Draws an edge of the sew line, with the names of its mates.
void draw_edge(std::ostream& out, const Page& page, const PatternPiece& piece, std::size_t e, const Vec2& shift) {
    const PieceEdge& edge = piece.edges[e];
    std::string seams, mates;
    for (const Mate& mate : edge.mates) {
        seams += (seams.empty() ? "" : " ") + xml_text(mate.seam);
        mates += (mates.empty() ? "" : ", ") + xml_text(mate.piece);
    }
    out << "<path class=\"sew\" stroke=\"#0000ff\" data-edge=\"" << std::to_string(e + 1) << '"';
    if (!seams.empty()) out << " data-seam=\"" << seams << "\" data-mate=\"" << mates << '"';
    out << " data-type=\"" << xml_text(edge.seam_type) << "\" data-length-mm=\""
        << format_fixed(edge.length / millimetre, 3) << "\" data-allowance-mm=\""
        << format_fixed(edge.allowance / millimetre, 3) << "\" d=\"" << open_path(page, piece.edge_line(e), shift)
        << "\"/>\n";
}

/// Draws a layer of a piece: a layer in Inkscape and programs that know its layers, a group in all others.
template <class Draw>
void draw_layer(std::ostream& out, const char* name, const Draw& draw) {
    std::ostringstream inside;
    draw(inside);
    if (inside.view().empty()) return;
    out << "<g inkscape:groupmode=\"layer\" inkscape:label=\"" << name << "\">\n" << inside.view() << "</g>\n";
}

void draw_sew_line(std::ostream& out, const Page& page, const PatternPiece& piece, const Vec2& shift) {
    const bool is_cut = piece.cut_line.rows() > 0;
    for (std::size_t e = 0; e < piece.edges.size(); ++e) draw_edge(out, page, piece, e, shift);
    if (piece.edges.empty() && is_cut && piece.sew_line.rows() > 0)
        out << "<path class=\"sew\" stroke=\"#0000ff\" d=\"" << closed_path(page, piece.sew_line, shift) << "\"/>\n";
}

void draw_notches(std::ostream& out, const Page& page, const PatternPiece& piece, const Vec2& shift) {
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits())
            out << "<path class=\"notch\" stroke=\"#ff0000\" data-seam=\"" << xml_text(notch.seam) << "\" d=\"M"
                << page.at(from + shift) << " L" << page.at(to + shift) << "\"/>\n";
}

void draw_grain(std::ostream& out, const Page& page, const PatternPiece& piece, const Vec2& shift) {
    const Points2 arrow = grain_arrow(piece);
    if (arrow.rows() != 4) return;
    const auto end = [&](int row) { return page.at(Vec2(arrow.row(row)) + shift); };
    out << "<path class=\"grain\" stroke=\"#0000ff\" d=\"M" << end(0) << " L" << end(1) << " M" << end(2) << " L"
        << end(1) << " L" << end(3) << "\"/>\n";
}

void draw(std::ostream& out, const Page& page, const PatternPiece& piece, const Vec2& shift, const std::string& id) {
    const std::string name = xml_text(piece.name);
    out << "<g id=\"" << id << "\" data-name=\"" << name << "\" inkscape:groupmode=\"layer\" inkscape:label=\"" << name
        << "\">\n";
    draw_layer(out, "cut", [&](std::ostream& layer) {
        if (piece.outline().rows() > 0)
            layer << "<path class=\"cut\" stroke=\"#ff0000\" d=\"" << closed_path(page, piece.outline(), shift)
                  << "\"/>\n";
    });
    draw_layer(out, "sew", [&](std::ostream& layer) { draw_sew_line(layer, page, piece, shift); });
    draw_layer(out, "notch", [&](std::ostream& layer) { draw_notches(layer, page, piece, shift); });
    draw_layer(out, "internal", [&](std::ostream& layer) {
        for (const DrawnLine& line : piece.lines)
            layer << "<path class=\"internal\" stroke=\"#0000ff\" data-name=\"" << xml_text(line.name) << "\" d=\""
                  << open_path(page, line.points, shift) << "\"/>\n";
    });
    draw_layer(out, "grain", [&](std::ostream& layer) { draw_grain(layer, page, piece, shift); });
    draw_layer(out, "text", [&](std::ostream& layer) {
        for (const Label& label : piece.labels) layer << text(page, label, shift, "#000000");
    });
    out << "</g>\n";
}

}  // namespace

void write_svg(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts) {
    const Sheet sheet = make_sheet(pieces, shifts);
    const Page page(sheet);
    const Vec2 size = (sheet.upper - sheet.lower + Vec2::Constant(2 * margin)) / millimetre;
    const std::string width = format_fixed(size.x(), 3), height = format_fixed(size.y(), 3);
    // A hairline on one piece would be invisible on a sheet of tens of metres. So the width grows with the sheet's
    // shorter side, which stays short for a marker of any length.
    const std::string stroke = format_fixed(std::max(0.2, size.minCoeff() / 2500), 1);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
        << "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"" << width << "mm\" height=\""
        << height << "mm\" viewBox=\"0 0 " << width << ' ' << height << "\">\n"
        << "<g fill=\"none\" stroke-width=\"" << stroke << "\" font-family=\"sans-serif\" text-anchor=\"middle\">\n";
    std::set<std::string> used{"reference"};
    for (std::size_t i = 0; i < pieces.size(); ++i)
        draw(out, page, pieces[i], sheet.shifts[i], unused_id(pieces[i].name, used));
    constexpr double side = Sheet::square_side;
    Points2 square(4, 2);
    square << 0, 0, side, 0, side, side, 0, side;
    out << "<g id=\"reference\" inkscape:groupmode=\"layer\" inkscape:label=\"reference\">\n<path stroke=\"#808080\" "
           "d=\""
        << closed_path(page, square, sheet.square) << "\"/>\n"
        << text(page, {"100 mm", Vec2(side / 2, side / 2), 0.01, 0}, sheet.square, "#808080") << "</g>\n</g>\n</svg>\n";
}

}  // namespace ripstop
