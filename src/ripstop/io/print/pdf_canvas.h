#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

using Colour = std::array<double, 3>;  ///< red, green, blue from 0 to 1
constexpr Colour black = {0, 0, 0};

/// How a line is drawn.
struct Ink {
    Colour colour = {0, 0, 0};
    double width = 0.0003;            ///< [m]
    std::vector<double> dashes = {};  ///< lengths of dashes and gaps in turn [m]; empty: a solid line
};

enum class Align { left, middle, right };

/// The pages of a PDF at true size, in metres from the lower left corner of the page, y up. The file depends
/// neither on the time nor on the machine. It asks the viewer to print without scaling (`/PrintScaling /None`).
class PdfCanvas {
  public:
    /// `date` is written into the file, YYYY-MM-DD; empty: no date.
    explicit PdfCanvas(const std::string& title, const std::string& date = {});
    ~PdfCanvas();
    PdfCanvas(const PdfCanvas&) = delete;
    PdfCanvas& operator=(const PdfCanvas&) = delete;

    /// Starts a page of this size [m]. `name` is its label in the viewer's list of pages.
    void begin_page(const Vec2& size, const std::string& name);
    /// Adds an entry for this page to the table of contents.
    void add_bookmark(const std::string& text);

    /// Restricts drawing to the box, until `end_clip`.
    void begin_clip(const Vec2& lower, const Vec2& upper);
    void end_clip();

    /// Draws a polyline. Its dash pattern starts `dashed` [m] into the pattern.
    void line(const Points2& points, const Ink& ink, double dashed = 0);
    void line(const Vec2& from, const Vec2& to, const Ink& ink);
    void rectangle(const Vec2& lower, const Vec2& upper, const Ink& ink);
    void circle(const Vec2& centre, double radius, const Ink& ink);
    /// Writes a text. `label.middle` is half the letters' height above the base line; along it, `align` says which
    /// part of the text is there. Letters shrink so that the text is at most `longest` [m] long.
    void text(const Label& label, const Colour& colour, Align align = Align::middle, double longest = 1e3);

    /// The bytes of the file. Nothing may be drawn afterwards. Throws std::runtime_error if cairo failed.
    std::string finish();

  private:
    struct Cairo;
    std::unique_ptr<Cairo> cairo_;
};

}  // namespace ripstop
