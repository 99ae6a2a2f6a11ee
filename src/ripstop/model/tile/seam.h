#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// The part of a boundary edge that belongs to a seam. If a seam ends inside an edge (a T-junction), two seams share
/// the edge.
struct SeamPart {
    int edge = 0;       ///< boundary edge of the tile: boundary[edge] to boundary[edge + 1]
    double length = 0;  ///< length of the part, measured on the common seam curve [m]
};

/// One side of a seam: a run of boundary edges within one chain of a tile.
struct SeamSide {
    int tile = 0;                          ///< index in `Envelope::tiles`
    int chain = 0;                         ///< index in `Tile::chains`
    std::vector<SeamPart> parts;           ///< in boundary order, counter-clockwise seen from outside
    std::optional<double> allowance = {};  ///< seam allowance of this side if it differs from the type's [m]
};

/// The place of an additional sheet in the seam between two others.
struct SewnInto {
    int seam = 0;            ///< index of that seam in the same list, before this one
    double from = 0;         ///< lowest place on that seam's curve, from its start [m]
    bool backwards = false;  ///< this seam starts at its highest place there
};

/// Two boundary runs that are sewn together. Both are measured along one curve, so their lengths agree even if the
/// two tiles are meshed differently. Side b runs against side a: the seam starts where a's parts begin and b's end.
///
/// Where three or more sheets meet they form one seam. It is stored as the seam between two of them, the skin, plus a
/// record with `into` for each additional sheet (a rib, a fin, a diaphragm). Side a of that record is the additional
/// sheet; side b repeats the side of the skin's seam that runs against it. All are measured along the curve of the
/// skin's seam.
struct Seam {
    std::string id;
    SeamSide a, b;                      ///< both the same tile if it is sewn to itself
    double length = 0;                  ///< length of the common curve [m]: the sum of the parts of either side
    double uncertainty = 0;             ///< uncertainty of `length` due to the meshes [m]
    double gap = 0;                     ///< largest distance between the two sides in space [m]
    SeamType type = {};                 ///< how it is sewn
    std::optional<SewnInto> into = {};  ///< set for an additional sheet in the seam between two others

    /// The seam allowance of one of its sides [m].
    double allowance(const SeamSide& side) const { return side.allowance.value_or(type.allowance); }
    /// The sides that no earlier record has: both, but only side a for an additional sheet.
    std::vector<const SeamSide*> own_sides() const { return into ? std::vector{&a} : std::vector{&a, &b}; }
    /// Whether a load tape runs along the seam. A seam has at most one, however many sheets it joins.
    bool has_tape() const { return type.tape && !into; }
    /// Converts an arc length on this seam's curve to one on the curve of the seam it lies in [m]; the same if it
    /// lies in none.
    double along_skin(double along) const {
        return !into ? along : into->backwards ? into->from + length - along : into->from + along;
    }
};

}  // namespace ripstop
