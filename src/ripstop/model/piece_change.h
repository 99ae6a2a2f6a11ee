#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// A word or number of a piece that is another in the other revision.
struct FieldChange {
    std::string field, before, after;
};

/// An edge in two revisions; lengths in metres.
struct EdgeChange {
    int edge = 0;  ///< from 0
    double length_before = 0, length_after = 0;
    double allowance_before = 0, allowance_after = 0;
    std::string type_before = {}, type_after = {};
    int notches_before = 0, notches_after = 0;
    double notch_moved = 0;  ///< the furthest along the edge; 0 where they are not as many
};

/// What became of a piece from one revision to the next.
struct PieceChange {
    enum class Kind { added, gone, changed };

    std::string piece;
    Kind kind = Kind::changed;
    double area_before = 0, area_after = 0;            ///< of what is cut [m2]
    double perimeter_before = 0, perimeter_after = 0;  ///< of the sew line [m]
    double distance = 0;                               ///< largest of one cut line from the other, both as they lie [m]
    double distance_fitted = 0;                        ///< and after the best rigid motion [m]
    double grain_turn = 0;  ///< by how much the warp turned within the piece, counter-clockwise [rad]
    int edges_before = 0, edges_after = 0;
    std::vector<EdgeChange> edges = {};  ///< those that changed; none where there are not as many
    std::vector<FieldChange> fields = {};
};

}  // namespace ripstop
