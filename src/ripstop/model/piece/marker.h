#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The placement of one copy of a piece on the roll: x is along the roll (the warp), y across it.
struct Placement {
    std::size_t piece = 0;   ///< index in `PieceSet::pieces`
    int copy = 0;            ///< from 1, counting all copies of a pattern, mirrored ones included; 0: the piece itself
    bool mirrored = false;   ///< one of `PatternPiece::quantity_mirrored`: the mirror image is wanted
    bool face_down = false;  ///< laid with the outside of the cloth down; only if the cloth may be turned over
    double turn = 0;         ///< rotation [rad], counter-clockwise, after mirroring: 0 or pi within the grain tolerance
    Vec2 shift = Vec2::Zero();  ///< translation after the rotation [m]

    /// Whether the outline is mirrored (y to -y). A mirror image laid face down is not.
    bool is_drawn_mirrored() const { return mirrored != face_down; }
    /// Points of the piece (#P x 2) transformed to their place on the roll, in the same order.
    Points2 placed(const Points2& points) const;
};

/// A length of cloth without a join.
struct RollPart {
    double start = 0;   ///< position on the marker [m]
    double length = 0;  ///< length of the cloth [m]; on an endless roll the length used
    double used = 0;    ///< length up to the end of the last piece [m]
};

/// The marker of one fabric and colour: its pieces as laid on the roll.
struct Marker {
    std::string fabric, colour;
    double roll_width = 0;  ///< [m]
    double length = 0;      ///< length of cloth that the marker takes, waste before joins included [m]
    double net_area = 0;    ///< area of all laid outlines [m2]
    std::vector<RollPart> parts = {};
    std::vector<Placement> placements = {};  ///< sorted from the start of the roll

    double gross_area() const { return roll_width * length; }
    double utilisation() const { return length > 0 ? net_area / gross_area() : 0; }
};

/// A piece that could not be laid, with the reason and a remedy.
struct Refusal {
    std::string piece, reason;
    int quantity = 1;  ///< number of copies, mirrored ones included
};

/// All markers and the pieces that could not be laid.
struct Markers {
    std::vector<Marker> markers;    ///< sorted by fabric, then colour
    std::vector<Refusal> refusals;  ///< one per piece
};

}  // namespace ripstop
