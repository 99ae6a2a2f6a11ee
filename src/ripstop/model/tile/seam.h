#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// The part of a boundary edge that belongs to a seam. Where a seam ends within an edge (a T-junction), the edge
/// belongs to two seams, a part each.
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

/// Where a further sheet lies in the seam of two others.
struct SewnInto {
    int seam = 0;            ///< of the two, in the same list, before this one
    double from = 0;         ///< the lowest place on that seam's curve, from its start [m]
    bool backwards = false;  ///< this seam's start is the highest
};

/// Two runs of boundary that are sewn together. Both are measured on one curve, so their lengths agree however
/// differently the two tiles are meshed. Side b runs against side a: the seam's start is where a's parts begin and b's
/// end.
///
/// Where three or more sheets meet on an edge they are one seam, kept as that of two of them, the skin, and one more
/// record for each further sheet (a rib, a fin, a diaphragm) with `into`: its side a is the further sheet, its side b
/// again that side of the skin's seam which runs against it. All are measured on the curve of the skin's seam.
struct Seam {
    std::string id;
    SeamSide a, b;                      ///< the same tile twice where it is sewn to itself
    double length = 0;                  ///< of the common curve [m]: the sum of the parts of either side
    double uncertainty = 0;             ///< by how much the meshes leave `length` open [m]
    double gap = 0;                     ///< largest distance between the two sides in space [m]
    SeamType type = {};                 ///< how it is sewn
    std::optional<SewnInto> into = {};  ///< a further sheet in the seam of two others

    /// Cloth beyond the sew line on one of its sides [m].
    double allowance(const SeamSide& side) const { return side.allowance.value_or(type.allowance); }
    /// The sides that no record before this one has: both, of a further sheet that sheet's alone.
    std::vector<const SeamSide*> own_sides() const { return into ? std::vector{&a} : std::vector{&a, &b}; }
    /// Does a load tape run along it? One seam takes one, however many sheets it has.
    bool has_tape() const { return type.tape && !into; }
    /// Where a place on this seam's curve is on that of the seam it lies in [m]; without one the same place.
    double along_skin(double along) const {
        return !into ? along : into->backwards ? into->from + length - along : into->from + along;
    }
};

}  // namespace ripstop
