#pragma once

#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/nest/row_profile.h"

namespace ripstop {

/// A way a kind of outline may lie on the roll: turned, perhaps mirrored, its lower left corner at the origin.
struct LaidShape {
    int kind = 0;
    double turn = 0;         ///< [rad]
    bool face_down = false;  ///< with the other side of the cloth up
    Vec2 corner =
        Vec2::Zero();          ///< lower left of the outline as turned and mirrored, before it was moved to the origin
    double lift = 0;           ///< of its lower left corner above the row it lies on [m]
    Vec2 size = Vec2::Zero();  ///< along the roll and across it [m]
    double area = 0;           ///< of the outline [m2]
    Points2 grown = {};        ///< the outline and all within half the gap of it, simplified and lifted
    int last_row = 0;          ///< the highest row it may lie on
    RowProfile profile = {};
};

/// The outline and everything within `distance` of it [m], and at most 0.2 mm more at its sides: points of it that are
/// within 0.1 mm of the line through others are left out first. Corners are mitred [Clipper].
Points2 grown_outline(const Points2& outline, double distance);

}  // namespace ripstop
