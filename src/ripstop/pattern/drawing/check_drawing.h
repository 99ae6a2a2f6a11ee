#pragma once

#include <optional>
#include <string>

#include "ripstop/model/piece/drawing_check.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// What `check_drawing` is told that a drawing does not say.
struct DrawingCheckOptions {
    std::optional<LengthUnit> unit = {};  ///< of the drawing, whatever it says of itself
    std::optional<double> roll = {};      ///< width of the cloth that pieces have to fit on [m]
};

/// Is a pattern file sound: does it say its unit, are its contours closed, each there once, crossing themselves and
/// each other nowhere, of a size that pieces have, with their sew lines in them; is each block a piece?
///
/// Convention: numbered layers where blocks hold lines on layer 1 (contours on 1, 11 and 14), named where there is a
/// layer CUT (CUT and SEW), else none known, and every line that closes is a contour. Lines that meet within 0.01 mm
/// are one, so an outline in edges is closed. Of the places with a fault the first of each kind and piece is told. A
/// drawing without contour is not sound. O(n log n) for n points, and at worst each contour against itself.
DrawingCheck check_drawing(const PatternDrawing& drawing, const DrawingCheckOptions& options = {});

/// What is left out, in words: `line 12: 2 image on layer art at (10, 20) mm not looked at`.
std::string unread_text(const UnreadEntity& entity, double metres_per_unit);

}  // namespace ripstop
