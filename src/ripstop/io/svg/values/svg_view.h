#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>

#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// The product of a list of translate, scale, rotate, skewX, skewY and matrix, as an attribute or as CSS
/// (translateX, translateY, scaleX, scaleY, skew, units: `rotate(0.5turn) translateX(3mm)`). The identity for an
/// empty text and for `none`. Throws InputError that begins with `place` if the text is not such a list.
Eigen::Affine2d svg_transform(std::string_view text, const SvgBasis& basis, const std::string& place);

/// True if CSS accepts the list. CSS requires units for shifts and angles, and commas between numbers; otherwise
/// the whole list has no effect. True for unknown functions.
bool is_css_transform(std::string_view text);

/// `transform-origin` relative to the corner of a box of the size `basis.viewport`: one or two lengths,
/// percentages or keywords (`left`, `center`, `bottom`). The corner for an empty text. Nothing if it is not
/// understood.
std::optional<Vec2> svg_transform_origin(std::string_view text, const SvgBasis& basis);

/// How a viewBox fits its viewport, by `preserveAspectRatio` (`xMidYMid meet` by default and for unknown values).
struct SvgFit {
    bool is_stretched = false;  ///< `none`: each side has its own scale
    bool is_slice = false;      ///< use the larger of the two scales, else the smaller
    Vec2 share{0.5, 0.5};       ///< share of the leftover space that lies before the drawing

    explicit SvgFit(std::string_view preserve_aspect_ratio);
};

struct SvgViewBox {
    Vec2 corner, size;
};

/// Nothing if there is no viewBox or it is invalid: not four numbers, or a negative size. A viewBox with a side of
/// 0 shows nothing.
std::optional<SvgViewBox> svg_view_box(std::string_view text);

/// The map from the viewBox to a viewport of `size` with its corner at the origin.
Eigen::Affine2d svg_view(const SvgViewBox& box, const Vec2& size, const SvgFit& fit);

}  // namespace ripstop
