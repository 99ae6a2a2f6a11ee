#include "ripstop/io/dxf/dxf_entities.h"

#include <cmath>
#include <ostream>
#include <utility>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/io/text/sheet.h"

namespace ripstop {
namespace {

/// Removes control codes: "%%d" would become a degree sign, "^J" a line end.
std::string without_codes(std::string text) {
    for (char& c : text)
        if (c == '^') c = '_';
    for (std::size_t at; (at = text.find("%%")) != std::string::npos;) text.erase(at, 1);
    return text;
}

std::string dxf_text(const std::string& text) {
    return without_codes(ascii_text(text));
}

/// The start of a centred text, if a letter of an average font is 0.9 of its height wide.
Vec2 text_start(const Label& label, std::size_t letters) {
    const Vec2 along(std::cos(label.turn), std::sin(label.turn)), up(-along.y(), along.x());
    const double half_width = 0.45 * label.height * static_cast<double>(letters);
    return label.middle - half_width * along - 0.5 * label.height * up;
}

}  // namespace

std::string dxf_millimetres(double metres) {
    return format_fixed(metres / millimetre, 4);
}

void DxfEntities::pair(int code, const std::string& value) {
    const std::string digits = std::to_string(code);
    out_ << std::string(3 - digits.size(), ' ') << digits << "\r\n" << value << "\r\n";
}

void DxfEntities::number(int code, double metres) {
    pair(code, dxf_millimetres(metres));
}

void DxfEntities::point(int code, const Vec2& p) {
    number(code, p.x());
    number(code + 10, p.y());
    pair(code + 20, "0.0");
}

void DxfEntities::entity(const char* type, const char* layer) {
    pair(0, type);
    pair(8, layer);
}

void DxfEntities::begin(const char* section) {
    pair(0, "SECTION");
    pair(2, section);
}

void DxfEntities::begin_table(const char* name, int entries) {
    pair(0, "TABLE");
    pair(2, name);
    pair(70, entries);
}

void DxfEntities::symbol(const char* type, const char* name) {
    pair(0, type);
    pair(2, name);
    pair(70, 0);
}

void DxfEntities::tables(const std::vector<DxfLayer>& layers) {
    begin("TABLES");
    begin_table("LTYPE", 1);
    symbol("LTYPE", "CONTINUOUS");
    pair(3, "Solid line");
    pair(72, 65);
    pair(73, 0);
    pair(40, "0.0");
    pair(0, "ENDTAB");
    begin_table("LAYER", static_cast<int>(layers.size()));
    for (const DxfLayer& layer : layers) {
        symbol("LAYER", layer.name);
        pair(62, layer.colour);
        pair(6, "CONTINUOUS");
    }
    pair(0, "ENDTAB");
    begin_table("STYLE", 1);
    symbol("STYLE", "STANDARD");
    pair(40, "0.0");
    pair(41, "1.0");
    pair(50, "0.0");
    pair(71, 0);
    pair(42, "10.0");
    pair(3, "txt");
    pair(4, "");
    pair(0, "ENDTAB");
    end();
}

void DxfEntities::polyline(const char* layer, const Points2& corners, bool is_closed) {
    std::vector<std::pair<std::string, std::string>> written;
    for (Eigen::Index i = 0; i < corners.rows(); ++i) {
        std::pair corner(dxf_millimetres(corners(i, 0)), dxf_millimetres(corners(i, 1)));
        if (written.empty() || corner != written.back()) written.push_back(std::move(corner));
    }
    while (is_closed && written.size() > 1 && written.front() == written.back()) written.pop_back();
    if (written.size() < 2) return;
    entity("POLYLINE", layer);
    pair(66, 1);
    pair(70, is_closed ? 1 : 0);
    point(10, Vec2::Zero());
    for (const auto& [x, y] : written) {
        entity("VERTEX", layer);
        pair(10, x);
        pair(20, y);
        pair(30, "0.0");
    }
    entity("SEQEND", layer);
}

void DxfEntities::line(const char* layer, const Vec2& from, const Vec2& to) {
    entity("LINE", layer);
    point(10, from);
    point(11, to);
}

void DxfEntities::centred_text(const char* layer, const Label& label) {
    const std::string ascii = dxf_text(label.text);
    entity("TEXT", layer);
    point(10, text_start(label, ascii.size()));
    number(40, label.height);
    pair(1, ascii);
    pair(50, format_fixed(label.turn / degree, 4));
    pair(7, "STANDARD");
    pair(72, 1);
    pair(73, 2);
    point(11, label.middle);
}

void DxfEntities::text(const char* layer, const Label& label) {
    text_at(layer, label.text, text_start(label, dxf_text(label.text).size()), label.height, label.turn);
}

void DxfEntities::text_at(const char* layer, const std::string& text, const Vec2& at, double height, double turn) {
    entity("TEXT", layer);
    point(10, at);
    number(40, height);
    pair(1, dxf_text(text));
    if (turn != 0) pair(50, format_fixed(turn / degree, 4));
    pair(7, "STANDARD");
}

void draw_grain_arrow(DxfEntities& out, const char* layer, const PatternPiece& piece) {
    const Points2 arrow = grain_arrow(piece);
    if (arrow.rows() != 4) return;
    for (const int end : {0, 2, 3}) out.line(layer, arrow.row(end), arrow.row(1));
}

void draw_slits(DxfEntities& out, const char* layer, const PatternPiece& piece) {
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits()) out.line(layer, from, to);
}

}  // namespace ripstop
