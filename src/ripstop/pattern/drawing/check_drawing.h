#pragma once

#include <optional>
#include <string>

#include "ripstop/model/piece/drawing_check.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// What `check_drawing` must know beyond the drawing.
struct DrawingCheckOptions {
    std::optional<LengthUnit> unit = {};  ///< overrides the unit that the drawing states
    std::optional<double> roll = {};      ///< width of the cloth that pieces must fit on [m]
};

/// Checks a pattern file: does it state its unit? Are its contours closed and unique, without crossing themselves
/// or each other? Do they have the size of pieces and contain their sew lines? Is each block a piece?
///
/// The layer convention is recognized. It is numbered if blocks have lines on layer 1 (contours on 1, 11 and 14),
/// and named if there is a layer CUT (CUT and SEW). Otherwise it is unknown, and every closed line is a contour.
/// Lines that meet within 0.01 mm are joined, so an outline in separate edges is closed. Of the faults of one kind
/// and piece, the first is reported. A drawing without contours fails. O(n log n) for n points; at worst each
/// contour is compared with itself.
DrawingCheck check_drawing(const PatternDrawing& drawing, const DrawingCheckOptions& options = {});

/// A sentence on an entity that was not read: `line 12: 2 image on layer art at (10, 20) mm not looked at`.
std::string unread_text(const UnreadEntity& entity, double metres_per_unit);

}  // namespace ripstop
