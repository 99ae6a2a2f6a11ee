#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A layer as a DXF declares it; its colour is AutoCAD's index.
struct DxfLayer {
    const char* name;
    int colour;
};

/// Writes what a DXF of Release 10 to 12 is made of: group codes right-aligned, CR LF, coordinates in millimetres with
/// four decimals, texts in ASCII without control codes. Everything is given in metres and radians.
class DxfEntities {
  public:
    explicit DxfEntities(std::ostream& out) : out_(out) {}

    void pair(int code, const std::string& value);
    void pair(int code, int value) { pair(code, std::to_string(value)); }
    void number(int code, double metres);  ///< a length
    void point(int code, const Vec2& p);   ///< `code`, `code` + 10 and `code` + 20
    void variable(const char* name) { pair(9, name); }
    void entity(const char* type, const char* layer);
    void begin(const char* section);
    void end() { pair(0, "ENDSEC"); }

    /// The TABLES section: line type CONTINUOUS, these layers, style STANDARD.
    void tables(const std::vector<DxfLayer>& layers);

    /// A POLYLINE; corners that are the same as written are written once, one that is left with one point is not
    /// written.
    void polyline(const char* layer, const Points2& corners, bool is_closed);
    void line(const char* layer, const Vec2& from, const Vec2& to);
    /// Centred on its middle; readers that ignore the alignment find the start of an average font's text in 10/20.
    void centred_text(const char* layer, const Label& label);
    /// Begins where an average font's text begins that is centred there, without alignment: all readers take that.
    void text(const char* layer, const Label& label);
    /// Begins at `at`.
    void text_at(const char* layer, const std::string& text, const Vec2& at, double height, double turn = 0);

  private:
    void begin_table(const char* name, int entries);
    void symbol(const char* type, const char* name);

    std::ostream& out_;
};

/// A length as it is written.
std::string dxf_millimetres(double metres);

/// The shaft and the barbs of the grain arrow, as lines.
void draw_grain_arrow(DxfEntities& out, const char* layer, const PatternPiece& piece);

/// The slits of all notches, as lines.
void draw_slits(DxfEntities& out, const char* layer, const PatternPiece& piece);

}  // namespace ripstop
