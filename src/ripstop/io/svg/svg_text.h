#pragma once

#include <string>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// A line of letters from one place on.
struct SvgTextLine {
    std::string text;  ///< blanks joined, UTF-8
    Vec2 at = Vec2::Zero();
    double height = 0;  ///< font-size [user units]; 0: not known
};

/// What a text element says: a line for each tspan that has a place of its own, else one. Of a list of places, a letter
/// each, the first counts. What is hidden is left out; the text along a path (`textPath`) too, and `has_text_path` is
/// set.
struct SvgText {
    std::vector<SvgTextLine> lines = {};
    bool has_text_path = false;
};

/// `basis` is that of the text element, its own font size in it.
SvgText svg_text(const pugi::xml_node& element, const SvgStyles& styles, const SvgBasis& basis, bool is_visible);

/// The basis within an element: with its font size where it has one.
SvgBasis svg_basis_within(const SvgBasis& basis, const SvgStyle& style);

}  // namespace ripstop
