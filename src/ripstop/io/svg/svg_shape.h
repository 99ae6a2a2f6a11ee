#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_curve.h"
#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// The outlines of an element, in its own user units.
struct SvgShape {
    std::vector<SvgRun> runs = {};  ///< empty if the element draws nothing, as with a side or radius of 0
    std::vector<std::string>
        unclear;  ///< attributes with a value that is not understood, `width="3vw"`; nothing is drawn then
};

/// The shape of a path, rect, circle, ellipse, line, polyline or polygon; nothing for another element. Throws
/// InputError that begins with `place` for a malformed path or list of points.
std::optional<SvgShape> svg_shape(const pugi::xml_node& element, const SvgStyle& style, const SvgBasis& basis,
                                  const std::string& place);

/// A length of an element, from its style or attribute; `otherwise` if it is absent or `auto`. If it is not
/// understood, returns 0 and adds it to `unclear`.
double svg_length_of(const pugi::xml_node& element, const SvgStyle& style, const char* key, SvgAxis axis,
                     const SvgBasis& basis, std::vector<std::string>& unclear, double otherwise = 0);

}  // namespace ripstop
