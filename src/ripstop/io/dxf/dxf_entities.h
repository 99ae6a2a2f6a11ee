#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// A layer as declared in a DXF. The colour is an index of AutoCAD.
struct DxfLayer {
    const char* name;
    int colour;
};

/// Writes the elements of a DXF of Release 10 to 12: right-aligned group codes, CR LF, coordinates in millimetres
/// with four decimals, ASCII texts without control codes. All arguments are in metres and radians.
class DxfEntities {
  public:
    explicit DxfEntities(std::ostream& out) : out_(out) {}

    void pair(int code, const std::string& value);
    void pair(int code, int value) { pair(code, std::to_string(value)); }
    void number(int code, double metres);  ///< a length
    void point(int code, const Vec2& p);   ///< codes `code`, `code` + 10 and `code` + 20
    void variable(const char* name) { pair(9, name); }
    void entity(const char* type, const char* layer);
    void begin(const char* section);
    void end() { pair(0, "ENDSEC"); }

    /// Writes the TABLES section: line type CONTINUOUS, these layers, style STANDARD.
    void tables(const std::vector<DxfLayer>& layers);

    /// Writes a POLYLINE. Neighbouring corners that coincide after rounding are written once; nothing is written
    /// if only one remains.
    void polyline(const char* layer, const Points2& corners, bool is_closed);
    void line(const char* layer, const Vec2& from, const Vec2& to);
    /// Writes a text centred on the label's middle. Codes 10/20 hold the estimated start of the text, for readers
    /// that ignore the alignment.
    void centred_text(const char* layer, const Label& label);
    /// Writes a text without alignment, which all readers accept. It begins where a centred text in an average
    /// font would.
    void text(const char* layer, const Label& label);
    /// Writes a text that begins at `at`.
    void text_at(const char* layer, const std::string& text, const Vec2& at, double height, double turn = 0);

  private:
    void begin_table(const char* name, int entries);
    void symbol(const char* type, const char* name);

    std::ostream& out_;
};

/// A length in millimetres, as DXF text.
std::string dxf_millimetres(double metres);

/// Draws the shaft and the barbs of the grain arrow as lines.
void draw_grain_arrow(DxfEntities& out, const char* layer, const PatternPiece& piece);

/// Draws the slits of all notches as lines.
void draw_slits(DxfEntities& out, const char* layer, const PatternPiece& piece);

}  // namespace ripstop
