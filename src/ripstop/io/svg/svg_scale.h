#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_curve.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// How the root's user units become the numbers of the drawing.
struct SvgScale {
    Eigen::Affine2d motion =
        Eigen::Affine2d::Identity();     ///< y up; a page stretched by `preserveAspectRatio="none"` too
    std::vector<StatedUnit> units = {};  ///< the one SVG takes first; none: it says none
    Vec2 viewport;                       ///< what per cent refer to [user units]; NaN where it is not known
    bool is_pixel = false;               ///< there is no viewBox: a user unit is a px of CSS, 1/96 inch

    /// Chords within 0.05 mm and a thousandth of each curve. Without a unit whoever reads on takes what he likes, so
    /// within 1e-6.
    SvgSampling sampling() const;
};

/// By width, height, viewBox and preserveAspectRatio of the root. Where its sides make two units of the viewBox the
/// first is the smaller (the larger for `slice`), and the other is stated too.
///
/// Inkscape before 0.92 drew 90 px to the inch and Illustrator draws 72, where CSS has 96: where the file is written by
/// one of them and only px say how large it is, theirs is the first unit and that of CSS the second. Throws InputError
/// for a user unit of more than 10 m or no length.
SvgScale svg_scale(const SvgDocument& document, const SvgStyle& style);

}  // namespace ripstop
