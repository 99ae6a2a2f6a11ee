#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/seam_type.h"

namespace ripstop {

/// The part of a boundary edge that belongs to a seam. Where a seam ends within an edge (a T-junction), the edge belongs to
/// two seams, a part each.
struct SeamPart {
    int edge = 0;       ///< of the tile's boundary: boundary[edge] to boundary[edge + 1]
    double length = 0;  ///< of the part, on the common seam curve [m]
};

/// One side of a seam: a run along a tile's boundary that lies within one of its chains.
struct SeamSide {
    int tile = 0;                          ///< in `Envelope::tiles`
    int chain = 0;                         ///< in `Tile::chains`
    std::vector<SeamPart> parts;           ///< in the order of the tile's boundary, counter-clockwise seen from outside
    std::optional<double> allowance = {};  ///< cloth beyond the sew line on this side, where it is not the type's [m]
};

/// Two runs of boundary that are sewn together. Both are measured on one curve, so their lengths agree however differently
/// the two tiles are meshed. Side b runs against side a: the seam's start is where a's parts begin and b's end.
struct Seam {
    std::string id;
    SeamSide a, b;           ///< the same tile twice where it is sewn to itself
    double length = 0;       ///< of the common curve [m]: the sum of the parts of either side
    double uncertainty = 0;  ///< by how much the meshes leave `length` open [m]
    double gap = 0;          ///< largest distance between the two sides in space [m]
    SeamType type = {};      ///< how it is sewn

    /// Cloth beyond the sew line on one of its sides [m].
    double allowance(const SeamSide& side) const { return side.allowance.value_or(type.allowance); }
};

}  // namespace ripstop
