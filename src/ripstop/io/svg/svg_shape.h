#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_curve.h"
#include "ripstop/io/svg/values/svg_length.h"

namespace ripstop {

/// What an element draws, in its own user units.
struct SvgShape {
    std::vector<SvgRun> runs = {};  ///< none where it draws nothing: a side or radius of 0
    std::vector<std::string>
        unclear;  ///< attributes with a value that is not known here: `width="3vw"`; then nothing is drawn
};

/// Of a path, rect, circle, ellipse, line, polyline or polygon; nothing for another element. Throws InputError that
/// begins with `place` for a path or a list of points that cannot be read.
std::optional<SvgShape> svg_shape(const pugi::xml_node& element, const SvgStyle& style, const SvgBasis& basis,
                                  const std::string& place);

/// A length of an element, from its style or attribute; `otherwise` where it has none or `auto`. Where it is not known
/// it is 0 and `unclear` says so.
double svg_length_of(const pugi::xml_node& element, const SvgStyle& style, const char* key, SvgAxis axis,
                     const SvgBasis& basis, std::vector<std::string>& unclear, double otherwise = 0);

}  // namespace ripstop
