#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

#include "ripstop/io/svg_length.h"

namespace ripstop {

/// A list of translate, scale, rotate, skewX, skewY and matrix, as the attribute has it or CSS (translateX, translateY,
/// scaleX, scaleY, skew, units: `rotate(0.5turn) translateX(3mm)`). The identity for nothing and `none`. Throws
/// InputError that begins with `place` for what is no such list.
Eigen::Affine2d svg_transform(std::string_view text, const SvgBasis& basis, const std::string& place);

/// How a viewBox lies in its viewport, by `preserveAspectRatio` (`xMidYMid meet` where it says nothing that is known).
struct SvgFit {
    bool is_stretched = false;  ///< `none`: each side by its own scale
    bool is_slice = false;      ///< the larger of both scales, else the smaller
    Vec2 share{0.5, 0.5};       ///< of the room left over that lies before the drawing

    explicit SvgFit(std::string_view preserve_aspect_ratio);
};

struct SvgViewBox {
    Vec2 corner, size;
};

/// Nothing where there is none, or it cannot be used: other than four numbers, a size of 0 or less.
std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// From the viewBox to a viewport of `size` with its corner at the origin.
Eigen::Affine2d svg_view(const SvgViewBox& box, const Vec2& size, const SvgFit& fit);

}  // namespace ripstop
