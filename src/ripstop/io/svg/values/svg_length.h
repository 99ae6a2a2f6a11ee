#pragma once

#include <optional>
#include <string_view>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// User units in a millimetre: of 1/96 inch, as CSS and SVG have it.
inline constexpr double svg_units_per_mm = 96 / 25.4;

/// What a length in per cent is a part of: the width of the viewport, its height, or sqrt((w2 + h2)/2) of both.
enum class SvgAxis { x, y, both };

/// What lengths are measured by.
struct SvgBasis {
    std::optional<Vec2> viewport = {};     ///< width and height of the nearest svg or symbol [user units]
    std::optional<double> font_size = 16;  ///< of the element [user units]
    std::optional<double> root_font_size = 16;
};

/// A length such as `100mm`, `1e-3`, `50%` or `2em` in user units: mm, cm, in, pt, pc, px, Q, em, rem and %, in any
/// case of letters. Nothing for what is no such length (`auto`, `calc(1px + 2%)`, `3vw`, `2ex`) and for one whose basis
/// is not known.
std::optional<double> svg_length(std::string_view text, SvgAxis axis, const SvgBasis& basis);

/// Is it a length in mm, cm, in, pt, pc or Q?
bool is_absolute_svg_length(std::string_view text);

/// The size of letters from the value of `font-size`: a length, per cent of the parent's, larger, smaller, or a word of
/// CSS from xx-small (9) over medium (16) to xxx-large (48). Nothing where it is not known.
std::optional<double> svg_font_size(std::string_view text, const SvgBasis& parent);

/// An angle with deg (also without a unit), grad, rad or turn [rad].
std::optional<double> svg_angle(std::string_view text);

}  // namespace ripstop
