#pragma once

#include <vector>

#include "ripstop/model/pattern_piece.h"
#include "ripstop/model/piece_change.h"

namespace ripstop {

/// How well one outline covers another.
struct OutlineFit {
    double turn = 0;  ///< of the first before it is moved onto the second [rad]
    double root_mean_square = 0;
    double distance = 0;  ///< the largest, of either outline's points from the other [m]
};

/// The rigid motion (no mirroring) of outline `a` onto `b` of least mean squared distance: iterated closest points
/// [BM92] between 200 points spaced evenly along `a` and the outline `b`, from where they lie with the centroids
/// together, and from principal axis on principal axis either way; a turned fit counts only where it is better by a
/// tenth.
OutlineFit fit_outline(const Points2& a, const Points2& b);

/// Largest distance of the points of either outline, corners and 200 between, from the other [m].
double outline_distance(const Points2& a, const Points2& b);

/// What changed from one revision to the next, pieces matched by name: those gone and changed in the order of `before`,
/// then those added. Lengths that differ by no more than `tolerance` [m] are the same (areas: by that times the
/// perimeter; the turn of the grain: by that over half the piece's size). Edges are matched in their order.
std::vector<PieceChange> compare_pieces(const PieceSet& before, const PieceSet& after, double tolerance);

}  // namespace ripstop
