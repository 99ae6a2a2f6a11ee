#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

/// Building blocks of pictures, as SVG. Positions are in page units, y down.
namespace ripstop {

/// `x y` with two decimals, which suffice for a page.
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

/// The colours of `class_colour`, labelled 0, half of `limit` and `limit` with its unit, and the colour beyond.
std::string colour_bar(const Vec2& at, const std::string& title, double limit, const std::string& unit);

/// The longest length of 1, 2 or 5 times a power of ten metres that is at most `widest` on the page, at `scale` units
/// per metre.
std::string scale_bar(const Vec2& at, double scale, double widest);

}  // namespace ripstop
