#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// How densely a walk places the notches of a seam.
struct WalkOptions {
    double notch_spacing = 0.25;  ///< at most this far apart [m]
    int least_intervals = 4;      ///< a short seam too is cut into so many parts by its notches
};

/// How long each boundary edge came out on the cloth [m] (boundary[i] to boundary[i + 1]), free of how finely the edge
/// is meshed. A method that holds edges at their lengths on the seams' curves (`edges_on_curve`) has made the cut line
/// as long as it says: the flat edge is taken as it is. Any other has worked on the mesh, whose edges are chords and
/// short of the curve by about theta^2 / 24 at a turn of theta an edge; that share is not its error, so what it did to
/// the chord is done to the curve:
///
///     on the cloth = |flat edge| * drawn length / chord
///
/// Two sides of a seam that are meshed differently are so measured alike.
Eigen::VectorXd boundary_on_cloth(const Tile& tile, const Points2& flat, bool edges_on_curve);

/// Walks every seam. The flat length of a part of an edge is its share of the edge's:
///
///     flat(part) = on the cloth(edge) * part.length / drawn length(edge)
///
/// so the sides agree to rounding wherever every edge has its drawn length, however the sides are meshed and wherever
/// other seams end along them. drift(s) = flat_b(s) - flat_a(s) is linear between the ends of the parts of both sides,
/// so its largest value is found exactly. Its limit is the tolerance on lengths times the seam's length, everywhere
/// along it: two sides of equal length whose marks do not meet halfway are not sewn flat. Real lengths are compared:
/// with compensation the sides agree where both are compensated alike. O(parts + notches).
std::vector<SeamWalk> walk_seams(const std::vector<FlatTile>& tiles, const std::vector<Seam>& seams,
                                 const Tolerances& tolerances, const WalkOptions& options = {});

}  // namespace ripstop
