#pragma once

#include <vector>

#include "ripstop/model/tile/seam.h"

namespace ripstop {

/// A sheet in a seam and the part of the seam's curve that it covers.
struct SeamSheet {
    const Seam* record = nullptr;    ///< the seam itself, or the record of the additional sheet
    const SeamSide* side = nullptr;  ///< side of that record
    double from = 0, to = 0;         ///< range on the seam's curve, ascending [m]
    bool backwards = false;          ///< its parts run from `to` to `from`
};

/// The sheets of each seam: a, b, then the additional ones in the order of their records. The entries of those
/// records are empty. The seams must outlive the result. O(#seams).
std::vector<std::vector<SeamSheet>> sheets_of_seams(const std::vector<Seam>& seams);

/// The parts of a sheet between two places of the seam's curve, in order. O(#parts).
std::vector<SeamPart> parts_between(const SeamSheet& sheet, double from, double to);

/// Finds the tiles with gas, or air, on both sides according to their seams: ribs, fins and diaphragms. Tiles joined
/// by two-sheet seams form one sheet. It is an inner sheet if the length along which it is sewn into seams of others
/// is at least the length along which others are sewn into its own. O(#seams).
std::vector<char> find_inner_sheets(int tiles, const std::vector<Seam>& seams);

}  // namespace ripstop
