#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

/// The parts that pictures are made of, as SVG. Places on the page are in its units, y down.
namespace ripstop {

/// Two decimals, which is all a page needs; `x y`.
std::string svg_number(double value);
std::string svg_pair(const Vec2& p);

struct TextStyle {
    double size = 14;
    const char* anchor = "start";
    const char* colour = "#1f2933";
    bool bold = false;
    bool halo = false;
};
std::string svg_text(const Vec2& at, const std::string& content, const TextStyle& style = {});

std::string svg_stroke(const std::vector<Vec2>& points, const std::string& colour, double width);

/// The colours of `class_colour` with the numbers 0, half of `limit` and `limit`, its unit behind it, and what is
/// beyond.
std::string colour_bar(const Vec2& at, const std::string& title, double limit, const std::string& unit);

/// The longest of 1, 2, 5 times a power of ten metres that is at most `widest` on the page, at `scale` units a metre.
std::string scale_bar(const Vec2& at, double scale, double widest);

}  // namespace ripstop
