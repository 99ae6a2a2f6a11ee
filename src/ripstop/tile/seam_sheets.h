#pragma once

#include <vector>

#include "ripstop/model/tile/seam.h"

namespace ripstop {

/// A sheet in a seam, and where along the seam's curve it lies.
struct SeamSheet {
    const Seam* record = nullptr;    ///< the seam itself, or the further sheet's
    const SeamSide* side = nullptr;  ///< of the record
    double from = 0, to = 0;         ///< on the seam's curve, ascending [m]
    bool backwards = false;          ///< its parts go from `to` to `from`
};

/// The sheets of each seam: a, b and the further ones in the order of their records. Nothing in the places of these
/// records. The seams must outlive it. O(#seams).
std::vector<std::vector<SeamSheet>> sheets_of_seams(const std::vector<Seam>& seams);

/// What of a sheet's parts lies between two places of the seam's curve, in their order. O(#parts).
std::vector<SeamPart> parts_between(const SeamSheet& sheet, double from, double to);

/// Which of so many tiles have the same gas, or the same air, on both sides by the way they are sewn: ribs, fins,
/// diaphragms. Tiles that seams of two hold together are one sheet; it is such a one where it is sewn into the seams of
/// others over at least as much length as others into its own. O(#seams).
std::vector<char> find_inner_sheets(int tiles, const std::vector<Seam>& seams);

}  // namespace ripstop
