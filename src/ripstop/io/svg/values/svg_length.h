#pragma once

#include <optional>
#include <string_view>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// User units per millimetre, if a user unit is 1/96 inch as in CSS and SVG.
inline constexpr double svg_units_per_mm = 96 / 25.4;

/// The reference of a length in per cent: the viewport's width w, its height h, or sqrt((w² + h²)/2).
enum class SvgAxis { x, y, both };

/// The reference of relative lengths.
struct SvgBasis {
    std::optional<Vec2> viewport = {};     ///< width and height of the nearest svg or symbol [user units]
    std::optional<double> font_size = 16;  ///< of the element [user units]
    std::optional<double> root_font_size = 16;
};

/// A length such as `100mm`, `1e-3`, `50%` or `2em`, in user units. Knows mm, cm, in, pt, pc, px, Q, em, rem and %
/// in any case. Nothing for anything else (`auto`, `calc(1px + 2%)`, `3vw`, `2ex`) and for a length whose basis is
/// unknown.
std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgBasis& basis);

/// True for a length in mm, cm, in, pt, pc or Q.
bool is_absolute_svg_length(std::string_view text);

/// The font size that a value of `font-size` gives: a length, per cent of the parent's, larger, smaller, or a
/// keyword of CSS from xx-small (9) over medium (16) to xxx-large (48). Nothing if it is unknown.
std::optional<double> svg_font_size(std::string_view text, const SvgBasis& parent);

/// An angle in deg (the default unit), grad, rad or turn, converted to radians.
std::optional<double> svg_angle(std::string_view text);

}  // namespace ripstop
