#pragma once

#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/nest/row_profile.h"

namespace ripstop {

/// An orientation in which a kind of outline may lie on the roll: turned, perhaps mirrored, its lower left corner
/// at the origin.
struct LaidShape {
    int kind = 0;
    double turn = 0;             ///< [rad]
    bool face_down = false;      ///< with the inside of the cloth up
    Vec2 corner = Vec2::Zero();  ///< lower left corner of the turned and mirrored outline before moving
    double lift = 0;             ///< height of its lower left corner above the row it lies on [m]
    Vec2 size = Vec2::Zero();    ///< along the roll, across the roll [m]
    double area = 0;             ///< of the outline [m²]
    Points2 grown = {};          ///< the outline offset by half the gap, simplified and lifted
    int last_row = 0;            ///< the highest row it may lie on
    RowProfile profile = {};
};

/// The outline offset outwards by `distance` [m], with mitred corners [Clipper]. It may be up to 0.2 mm wider,
/// because points within 0.1 mm of the line through their neighbours are removed first.
Points2 grown_outline(const Points2& outline, double distance);

}  // namespace ripstop
