#pragma once

#include <string>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// A line of text and its start.
struct SvgTextLine {
    std::string text;  ///< UTF-8, with runs of blanks joined
    Vec2 at = Vec2::Zero();
    double height = 0;  ///< font-size [user units]; 0: unknown
};

/// The lines of a text element: one for each tspan with its own place, else one in all. Of a list of places, one
/// per letter, the first is used. Hidden text is left out. Text along a path (`textPath`) is left out too and sets
/// `has_text_path`.
struct SvgText {
    std::vector<SvgTextLine> lines = {};
    bool has_text_path = false;
};

/// Reads a text element. `basis` belongs to that element and includes its own font size.
SvgText svg_text(const pugi::xml_node& element, const SvgStyles& styles, const SvgBasis& basis, bool is_visible);

/// The basis inside an element: with the element's font size, if it sets one.
SvgBasis svg_basis_within(const SvgBasis& basis, const SvgStyle& style);

}  // namespace ripstop
