#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The density of the notches in a walk.
struct WalkOptions {
    double notch_spacing = 0.25;  ///< largest distance between notches [m]
    int least_intervals = 4;      ///< the notches divide even a short seam into at least this many parts
};

/// The length of each boundary edge on the cloth [m] (boundary[i] to boundary[i + 1]), independent of the mesh
/// resolution. A method that holds edges at their lengths on the seams' curves (`edges_on_curve`) gives the cut line
/// that length directly, so the flat edge counts as it is. Other methods work on the mesh, whose edges are chords,
/// shorter than the curve by about theta^2 / 24 at a turn of theta per edge. That is not their error, so the curve
/// gets the same stretch as the chord:
///
///     on the cloth = |flat edge| * drawn length / chord
///
/// Two sides of a seam with different meshes are therefore measured alike.
Eigen::VectorXd boundary_on_cloth(const Tile& tile, const Points2& flat, bool edges_on_curve);

/// Walks every seam. A part of an edge has its share of the flat edge's length:
///
///     flat(part) = on the cloth(edge) * part.length / drawn length(edge)
///
/// So the sides agree to rounding wherever every edge has its drawn length, whatever the meshes and the other seams
/// along them. drift(s) = flat_b(s) - flat_a(s) is linear between the ends of the parts of both sides, so its maximum
/// is exact. Its limit is the length tolerance times the seam's length, at every place: two sides of equal length
/// cannot be sewn flat if their marks do not meet halfway. Actual lengths are compared: with compensation the sides
/// agree if both are compensated alike. O(parts + notches).
std::vector<SeamWalk> walk_seams(const std::vector<FlatTile>& tiles, const std::vector<Seam>& seams,
                                 const Tolerances& tolerances, const WalkOptions& options = {});

}  // namespace ripstop
