#include "ripstop/io/dxf.h"

#include <array>
#include <cmath>
#include <ostream>
#include <string>
#include <utility>

#include "ripstop/base/number_text.h"
#include "ripstop/base/units.h"
#include "ripstop/io/escape.h"
#include "ripstop/io/sheet.h"

namespace ripstop {
namespace {

struct Layer {
    const char* name;
    int colour;  ///< AutoCAD colour index
};
constexpr std::array layers{Layer{"CUT", 1},  Layer{"SEW", 3},      Layer{"NOTCH", 6}, Layer{"GRAIN", 5},
                            Layer{"TEXT", 7}, Layer{"INTERNAL", 4}, Layer{"REF", 8}};

std::string in_millimetres(double metres) {
    return format_fixed(metres / millimetre, 4);
}

class DxfWriter {
  public:
    explicit DxfWriter(std::ostream& out) : out_(out) {}

    void pair(int code, const std::string& value) {
        const std::string number = std::to_string(code);
        out_ << std::string(3 - number.size(), ' ') << number << "\r\n" << value << "\r\n";
    }
    void pair(int code, int value) { pair(code, std::to_string(value)); }
    void point(int code, const Vec2& p) {
        pair(code, in_millimetres(p.x()));
        pair(code + 10, in_millimetres(p.y()));
        pair(code + 20, "0.0");
    }

    void header(const Sheet& sheet) {
        pair(0, "SECTION");
        pair(2, "HEADER");
        pair(9, "$ACADVER");
        pair(1, "AC1009");
        pair(9, "$INSUNITS");
        pair(70, 4);
        pair(9, "$MEASUREMENT");
        pair(70, 1);
        pair(9, "$EXTMIN");
        point(10, sheet.lower);
        pair(9, "$EXTMAX");
        point(10, sheet.upper);
        pair(0, "ENDSEC");
    }

    void tables() {
        pair(0, "SECTION");
        pair(2, "TABLES");
        begin_table("LTYPE", 1);
        symbol("LTYPE", "CONTINUOUS");
        pair(3, "Solid line");
        pair(72, 65);
        pair(73, 0);
        pair(40, "0.0");
        pair(0, "ENDTAB");
        begin_table("LAYER", static_cast<int>(layers.size()));
        for (const Layer& layer : layers) {
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
        pair(0, "ENDSEC");
    }

    void closed_polyline(const char* layer, const Points2& corners, const Vec2& shift) {
        polyline(layer, corners, shift, true);
    }

    /// Points that are the same as written are written once.
    void polyline(const char* layer, const Points2& corners, const Vec2& shift, bool is_closed) {
        std::vector<std::pair<std::string, std::string>> written;
        for (Eigen::Index i = 0; i < corners.rows(); ++i) {
            const Vec2 p = Vec2(corners.row(i)) + shift;
            std::pair corner(in_millimetres(p.x()), in_millimetres(p.y()));
            if (written.empty() || corner != written.back()) written.push_back(std::move(corner));
        }
        while (is_closed && written.size() > 1 && written.front() == written.back()) written.pop_back();
        if (written.empty()) return;
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

    void line(const char* layer, const Vec2& from, const Vec2& to) {
        entity("LINE", layer);
        point(10, from);
        point(11, to);
    }

    /// Centred on its middle; readers that ignore the alignment find the start of an average font's text in 10/20.
    void text(const char* layer, const Label& label, const Vec2& shift) {
        const std::string ascii = without_codes(ascii_text(label.text));
        const Vec2 middle = label.middle + shift;
        const Vec2 along(std::cos(label.turn), std::sin(label.turn)), up(-along.y(), along.x());
        const double half_width = 0.45 * label.height * static_cast<double>(ascii.size());
        entity("TEXT", layer);
        point(10, middle - half_width * along - 0.5 * label.height * up);
        pair(40, in_millimetres(label.height));
        pair(1, ascii);
        pair(50, format_fixed(label.turn / degree, 4));
        pair(7, "STANDARD");
        pair(72, 1);
        pair(73, 2);
        point(11, middle);
    }

  private:
    void begin_table(const char* name, int entries) {
        pair(0, "TABLE");
        pair(2, name);
        pair(70, entries);
    }
    void symbol(const char* type, const char* name) {
        pair(0, type);
        pair(2, name);
        pair(70, 0);
    }
    void entity(const char* type, const char* layer) {
        pair(0, type);
        pair(8, layer);
    }
    /// "%%d" would become a degree sign, "^J" a line end.
    static std::string without_codes(std::string text) {
        for (char& c : text)
            if (c == '^') c = '_';
        for (std::size_t at; (at = text.find("%%")) != std::string::npos;) text.erase(at, 1);
        return text;
    }

    std::ostream& out_;
};

void draw(DxfWriter& writer, const PatternPiece& piece, const Vec2& shift) {
    writer.closed_polyline("CUT", piece.cut_line, shift);
    writer.closed_polyline("SEW", piece.sew_line, shift);
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits()) writer.line("NOTCH", from + shift, to + shift);
    for (const DrawnLine& line : piece.lines) writer.polyline("INTERNAL", line.points, shift, false);
    const Points2 arrow = grain_arrow(piece);
    if (arrow.rows() == 4) {
        const Vec2 head = Vec2(arrow.row(1)) + shift;
        for (const int end : {0, 2, 3}) writer.line("GRAIN", Vec2(arrow.row(end)) + shift, head);
    }
    for (const Label& label : piece.labels) writer.text("TEXT", label, shift);
}

}  // namespace

void write_dxf(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts) {
    const Sheet sheet = make_sheet(pieces, shifts);
    DxfWriter writer(out);
    writer.header(sheet);
    writer.tables();
    writer.pair(0, "SECTION");
    writer.pair(2, "ENTITIES");
    for (std::size_t i = 0; i < pieces.size(); ++i) draw(writer, pieces[i], sheet.shifts[i]);
    constexpr double side = Sheet::square_side;
    Points2 square(4, 2);
    square << 0, 0, side, 0, side, side, 0, side;
    writer.closed_polyline("REF", square, sheet.square);
    writer.text("REF", {"100 mm", Vec2(side / 2, side / 2), 0.01, 0}, sheet.square);
    writer.pair(0, "ENDSEC");
    writer.pair(0, "EOF");
}

}  // namespace ripstop
