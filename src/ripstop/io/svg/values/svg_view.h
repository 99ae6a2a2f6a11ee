#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// A list of translate, scale, rotate, skewX, skewY and matrix, as the attribute has it or CSS (translateX, translateY,
/// scaleX, scaleY, skew, units: `rotate(0.5turn) translateX(3mm)`). The identity for nothing and `none`. Throws
/// InputError that begins with `place` for what is no such list.
Eigen::Affine2d svg_transform(std::string_view text, const SvgBasis& basis, const std::string& place);

/// Does CSS take it? There a shift has units and a turn too, and commas part the numbers; a list that breaks this has
/// no effect at all. True for functions that are not known here.
bool is_css_transform(std::string_view text);

/// `transform-origin` from the corner of a box of the size `basis.viewport`: one or two lengths, shares or words
/// (`left`, `center`, `bottom`); the corner for nothing. Nothing where it is not known.
std::optional<Vec2> svg_transform_origin(std::string_view text, const SvgBasis& basis);

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

/// Nothing where there is none, or it cannot be used: other than four numbers, a size below 0. What has a side of 0
/// shows nothing.
std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// From the viewBox to a viewport of `size` with its corner at the origin.
Eigen::Affine2d svg_view(const SvgViewBox& box, const Vec2& size, const SvgFit& fit);

}  // namespace ripstop
