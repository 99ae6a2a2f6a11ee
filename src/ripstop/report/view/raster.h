#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// Calls `paint(place, depth)` for each pixel whose centre lies in a triangle, in a picture of `width` times `height`
/// pixels: place = row * width + column. Corners are in pixels, y down; z is the depth, interpolated linearly. Pixels
/// outside the picture and triangles seen edge-on are skipped. Neighbouring triangles share no pixel and leave no gap.
template <class Paint>
void each_pixel(int width, int height, const std::array<Vec3, 3>& corners, const Paint& paint) {
    const auto& [a, b, c] = corners;
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    if (!(std::abs(area) > 0) || !std::isfinite(area)) return;
    const double slope_x = ((b.z() - a.z()) * (c.y() - a.y()) - (c.z() - a.z()) * (b.y() - a.y())) / area;
    const double slope_y = ((c.z() - a.z()) * (b.x() - a.x()) - (b.z() - a.z()) * (c.x() - a.x())) / area;
    // Clamp before conversion to integers, which cannot represent far places.
    const auto inside = [](double from, double to, double last) {
        return std::array{static_cast<int>(std::clamp(std::ceil(from - 0.5), 0.0, last + 1)),
                          static_cast<int>(std::clamp(std::ceil(to - 0.5) - 1, -1.0, last))};
    };
    const auto [top, bottom] =
        inside(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), static_cast<double>(height - 1));
    for (int row = top; row <= bottom; ++row) {
        const double y = row + 0.5;
        double from = std::numeric_limits<double>::infinity(), to = -from;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 &p = corners[k], &q = corners[(k + 1) % 3];
            if ((p.y() <= y) == (q.y() <= y)) continue;
            const double at = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
            from = std::min(from, at);
            to = std::max(to, at);
        }
        const auto [first, last] = inside(from, to, static_cast<double>(width - 1));
        for (int column = first; column <= last; ++column)
            paint(row * width + column, a.z() + slope_x * (column + 0.5 - a.x()) + slope_y * (y - a.y()));
    }
}

}  // namespace ripstop
