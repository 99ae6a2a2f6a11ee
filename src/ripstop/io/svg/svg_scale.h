#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "ripstop/io/svg/style/svg_style.h"
#include "ripstop/io/svg/values/svg_curve.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// The conversion from the root's user units to the numbers of the drawing.
struct SvgScale {
    Eigen::Affine2d motion =
        Eigen::Affine2d::Identity();     ///< y up; includes the stretch of `preserveAspectRatio="none"`
    std::vector<StatedUnit> units = {};  ///< the first is the one that SVG prefers; empty: the file states none
    Vec2 viewport;                       ///< reference of lengths in per cent [user units]; NaN if unknown
    bool is_pixel = false;               ///< without a viewBox, a user unit is a CSS px, 1/96 inch

    /// Chords within 0.05 mm and a thousandth of each curve. If no unit is stated, the caller chooses one later,
    /// so the sampling is 1e-6 of each curve.
    SvgSampling sampling() const;
};

/// The scale that width, height, viewBox and preserveAspectRatio of the root give. If the two sides disagree, both
/// units are stated, first the smaller (the larger for `slice`).
///
/// CSS has 96 px per inch, but Inkscape before 0.92 had 90 and Illustrator has 72. If one of these wrote the file
/// and only px state its size, its unit comes first and that of CSS second. Throws InputError for a user unit that
/// is longer than 10 m or is no length.
SvgScale svg_scale(const SvgDocument& document, const SvgStyle& style);

}  // namespace ripstop
