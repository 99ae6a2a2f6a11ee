#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// A word or number of a piece that is another in the other revision.
struct FieldChange {
    std::string field, before, after;
};

/// A seam type of the set that is sewn otherwise in the other revision.
struct SeamTypeChange {
    std::string seam_type;
    std::vector<FieldChange> fields;
};

/// A drawn line (`DrawnLine`) of a piece.
struct LineChange {
    enum class Kind { added, gone, moved };

    std::string line;
    Kind kind = Kind::moved;
    double distance = 0;  ///< the largest of one from the other, after the best rigid motion of the piece [m]
};

/// Whom an edge is sewn to, and how much of it [m].
struct EdgeMate {
    std::string piece;
    double length = 0;
};

/// An edge in two revisions; lengths in metres.
struct EdgeChange {
    int edge = 0;  ///< from 0, as numbered before
    double length_before = 0, length_after = 0;
    double allowance_before = 0, allowance_after = 0;
    std::string type_before = {}, type_after = {};
    int notches_before = 0, notches_after = 0;
    double notch_moved = 0;  ///< the furthest along the edge; 0 where they are not as many
    int edge_after = edge;   ///< as numbered after
    double notch_depth_before = 0, notch_depth_after = 0;  ///< of the notch whose depth changed most; equal: of none
    int doubles_before = 0, doubles_after = 0;             ///< double notches
    std::vector<EdgeMate> mates_before = {}, mates_after = {};  ///< in the order of the edge; equal where none changed
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
    double sew_distance_fitted = 0;                    ///< of one sew line from the other, after the same motion [m]
    double grain_turn = 0;  ///< by how much the warp turned within the piece, counter-clockwise [rad]
    int edges_before = 0, edges_after = 0;
    std::vector<EdgeChange> edges = {};  ///< those that changed; none where there are not as many
    std::vector<FieldChange> fields = {};
    std::vector<LineChange> lines = {};
};

}  // namespace ripstop
