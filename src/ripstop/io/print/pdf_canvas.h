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
    std::vector<double> dashes = {};  ///< lengths of dash and gap in turn [m]; none: drawn through
};

enum class Align { left, middle, right };

/// The pages of a PDF, in true size: metres from the lower left corner of the page, y up. Nothing in the file depends
/// on the time or the place it is made. The file asks its reader to print it without scaling (`/PrintScaling /None`).
class PdfCanvas {
  public:
    /// `date`: of its making, YYYY-MM-DD; none: none is stated.
    explicit PdfCanvas(const std::string& title, const std::string& date = {});
    ~PdfCanvas();
    PdfCanvas(const PdfCanvas&) = delete;
    PdfCanvas& operator=(const PdfCanvas&) = delete;

    /// The next page, `size` [m], known as `name` in the reader's list of pages.
    void begin_page(const Vec2& size, const std::string& name);
    /// An entry in the reader's table of contents that leads to this page.
    void add_bookmark(const std::string& text);

    /// From here to `end_clip` nothing is drawn outside the box.
    void begin_clip(const Vec2& lower, const Vec2& upper);
    void end_clip();

    /// A polyline whose dashes begin `dashed` [m] into their pattern.
    void line(const Points2& points, const Ink& ink, double dashed = 0);
    void line(const Vec2& from, const Vec2& to, const Ink& ink);
    void rectangle(const Vec2& lower, const Vec2& upper, const Ink& ink);
    void circle(const Vec2& centre, double radius, const Ink& ink);
    /// `label.middle` is half the letters' height above the line they stand on and, along it, where `align` says.
    /// Letters shrink so that the text is no longer than `longest` [m].
    void text(const Label& label, const Colour& colour, Align align = Align::middle, double longest = 1e3);

    /// The file; nothing may be drawn after. Throws std::runtime_error where cairo could not.
    std::string finish();

  private:
    struct Cairo;
    std::unique_ptr<Cairo> cairo_;
};

}  // namespace ripstop
