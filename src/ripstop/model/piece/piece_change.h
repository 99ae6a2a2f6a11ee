#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// A field of a piece whose value differs between the two revisions.
struct FieldChange {
    std::string field, before, after;
};

/// A seam type that is sewn differently in the other revision.
struct SeamTypeChange {
    std::string seam_type;
    std::vector<FieldChange> fields;
};

/// A changed drawn line (`DrawnLine`) of a piece.
struct LineChange {
    enum class Kind { added, gone, moved };

    std::string line;
    Kind kind = Kind::moved;
    double distance = 0;  ///< Hausdorff distance after the best rigid motion of the piece [m]
};

/// The piece to which a part of an edge is sewn, and the length of that part [m].
struct EdgeMate {
    std::string piece;
    double length = 0;
};

/// The change of an edge between two revisions; lengths in metres.
struct EdgeChange {
    int edge = 0;  ///< edge number before, from 0
    double length_before = 0, length_after = 0;
    double allowance_before = 0, allowance_after = 0;
    std::string type_before = {}, type_after = {};
    int notches_before = 0, notches_after = 0;
    double notch_moved = 0;  ///< largest shift of a notch along the edge; 0 if the numbers of notches differ
    int edge_after = edge;   ///< edge number after
    double notch_depth_before = 0, notch_depth_after = 0;       ///< depth of the notch that changed most; equal if none
                                                                ///< changed
    int doubles_before = 0, doubles_after = 0;                  ///< number of double notches
    std::vector<EdgeMate> mates_before = {}, mates_after = {};  ///< in order along the edge; equal if none changed
};

/// The change of a piece from one revision to the next.
struct PieceChange {
    enum class Kind { added, gone, changed };

    std::string piece;
    Kind kind = Kind::changed;
    double area_before = 0, area_after = 0;            ///< area of the cut outline [m2]
    double perimeter_before = 0, perimeter_after = 0;  ///< perimeter of the sew line [m]
    double distance = 0;                               ///< Hausdorff distance of the cut lines as they lie [m]
    double distance_fitted = 0;                        ///< the same after the best rigid motion [m]
    double sew_distance_fitted = 0;                    ///< Hausdorff distance of the sew lines after that motion [m]
    double grain_turn = 0;  ///< rotation of the warp within the piece, counter-clockwise [rad]
    int edges_before = 0, edges_after = 0;
    std::vector<EdgeChange> edges = {};  ///< changed edges; empty if the numbers of edges differ
    std::vector<FieldChange> fields = {};
    std::vector<LineChange> lines = {};
};

}  // namespace ripstop
