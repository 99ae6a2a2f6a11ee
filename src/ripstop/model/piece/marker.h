#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/piece/pattern_piece.h"

namespace ripstop {

/// Where one copy of a piece lies on the roll: x along it, the warp, y across it.
struct Placement {
    std::size_t piece = 0;  ///< in `PieceSet::pieces`
    int copy = 0;  ///< from 1, of the copies of a pattern, mirror images counted with them; 0: the piece itself
    bool mirrored = false;   ///< one of `PatternPiece::quantity_mirrored`: the piece's mirror image is wanted
    bool face_down = false;  ///< laid with the outside of the cloth below; only where the cloth may be turned over
    double turn = 0;         ///< [rad], counter-clockwise, after mirroring: 0 or pi, give or take the grain tolerance
    Vec2 shift = Vec2::Zero();  ///< after turning [m]

    /// Is the outline drawn mirrored (y to -y)? A mirror image laid face down is not.
    bool is_drawn_mirrored() const { return mirrored != face_down; }
    /// Points of the piece, where they lie (#P x 2), in the piece's order.
    Points2 placed(const Points2& points) const;
};

/// A length of cloth without a join.
struct RollPart {
    double start = 0;   ///< on the marker [m]
    double length = 0;  ///< of the cloth [m]; as long as used where the roll has no end
    double used = 0;    ///< to the end of the last piece [m]
};

/// Pieces of one fabric and colour, laid on the roll.
struct Marker {
    std::string fabric, colour;
    double roll_width = 0;  ///< [m]
    double length = 0;      ///< of cloth the marker takes, cloth lost before joins included [m]
    double net_area = 0;    ///< of the outlines laid [m2]
    std::vector<RollPart> parts = {};
    std::vector<Placement> placements = {};  ///< from the start of the roll on

    double gross_area() const { return roll_width * length; }
    double utilisation() const { return length > 0 ? net_area / gross_area() : 0; }
};

/// A piece that could not be laid, and why, and what to do.
struct Refusal {
    std::string piece, reason;
    int quantity = 1;  ///< how many of it, mirror images counted with them
};

/// What became of all the pieces.
struct Markers {
    std::vector<Marker> markers;    ///< by fabric, then colour
    std::vector<Refusal> refusals;  ///< one a piece
};

/// The piece as it lies: turned, mirrored and shifted, with its copy in its name; all outlines counter-clockwise,
/// letters never mirrored and never upside down, lines in their order. A mirror image says so in its name and on its
/// label, and `cut 24` becomes `2/24` on a copy, and goes where each piece is laid itself.
PatternPiece placed_piece(const PatternPiece& piece, const Placement& placement);

}  // namespace ripstop
