#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Pixels, 0xRRGGBB each, row by row from the top.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint32_t> colours = {};
};

/// Pixels on a page, y down: the place of their upper left corner, and how many of them lie along one unit of the page.
struct PlacedPixels {
    Pixels pixels;
    Vec2 at = Vec2::Zero();
    double per_unit = 1;
};

/// A PNG file of an SVG drawing over the pixels beneath it, on white, a pixel a unit, as large as its `width` and
/// `height` say, rounded up. Pixels that are finer than the page are averaged. Names in any script show as the fonts
/// that are installed can. The same bytes for the same drawing and fonts; from several threads at once too.
///
/// Made by librsvg and cairo; some 50 ms a million pixels. Throws std::runtime_error where either fails: the drawing is
/// ours.
std::string png_picture(const std::string& svg, const std::vector<PlacedPixels>& beneath = {});

}  // namespace ripstop
