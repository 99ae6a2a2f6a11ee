#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Pixels as 0xRRGGBB, row by row from the top.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint32_t> colours = {};
};

/// Pixels on a page, y down: the place of their upper left corner, and the number of pixels per unit of the page.
struct PlacedPixels {
    Pixels pixels;
    Vec2 at = Vec2::Zero();
    double per_unit = 1;
};

/// A PNG picture of an SVG drawing over the pixels beneath it, on white, one pixel per unit, with the drawing's
/// `width` and `height` rounded up. Pixels that are finer than the page are averaged. Names may be in any script that
/// the installed fonts contain. The same drawing and fonts give the same bytes. Safe to call from several threads.
///
/// Uses librsvg and cairo; takes about 50 ms per million pixels. Throws std::runtime_error if either fails, and not
/// InputError, because the program makes the drawing itself.
std::string png_picture(const std::string& svg, const std::vector<PlacedPixels>& beneath = {});

}  // namespace ripstop
