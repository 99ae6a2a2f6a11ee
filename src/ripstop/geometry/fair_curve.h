#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A chain of edges on a surface as intrinsic data: its edge lengths and its turns, the same as seen by somebody who
/// walks along it. On a developable surface this is the unrolled chain.
struct ChainLayout {
    Eigen::VectorXd lengths;  ///< edge lengths [m]; a closed chain has one per vertex, the last leads back to the first
    Eigen::VectorXd
        turns;  ///< turning angles at the vertices, positive to the left [rad]; undefined at the ends of an open chain
    bool closed = false;
};

/// The layout of a chain in the plane (#N x 2). A closed chain does not repeat its first vertex.
ChainLayout layout_of(const Points2& chain, bool closed);

/// The result of fairing a chain.
struct FairLine {
    double length = 0;        ///< length of the smooth curve through the faired vertices [m]
    double area_on_left = 0;  ///< area between the chain and the curve, positive where the curve lies to the left [m2]
    Points2 moves;  ///< #N x 2: from each vertex to its faired place, as components along the chain and to its left [m]
};

/// The smooth curve that a zigzag chain of edges stands for, such as a cut along the edges of a mesh. Let p be the
/// laid out vertices at the stations s. Of all curves f, the fair curve minimizes
///
///     sum_i w_i |f_i - p_i|^2 + r^6 integral |f''' + k^2 f'|^2 ds        w: half the two edges beside a vertex
///
/// The same fit is then applied to the residual p - f and added, so that slow bends are kept. The second term
/// vanishes for a straight line and for a circle of curvature k. This is the smoothing spline in tension of order
/// three (Reinsch 1967 with another operator): it damps wavelengths below some 2 pi r and keeps longer ones. r is
/// three mean edges.
///
/// The stations s are the arc length of a first fit, not of the chain, because teeth advance by almost nothing. k is
/// the turning of that fit over its length, computed for each image of the chain on its own. An open chain keeps its
/// two ends. A closed chain is walked round once and a little more with free ends, and the overlap is dropped. A
/// chain and its image on the cloth are therefore smoothed alike, vertex by vertex. Where the cloth keeps the lengths
/// and turns of the chain, both curves have the same length to rounding.
class FairCurve {
  public:
    /// Requires at least four vertices (six if closed) and no edge of length 0. O(#N).
    explicit FairCurve(const ChainLayout& chain);

    const FairLine& line() const { return line_; }
    FairLine of_image(const ChainLayout& image) const;

  private:
    double reach_ = 0, first_reach_ = 0;  ///< r of the second and of the first fit [m]
    Eigen::VectorXd first_,
        steps_;  ///< distances between consecutive laid out vertices: along the chain, along the first fit [m]
    FairLine line_;
};

/// The vertices of a chain in the plane (#N x 2), moved to its fair curve. A closed chain stays closed, which the
/// layout of a chain on a surface need not be, so waves as long as its round are damped too.
Points2 fair_points(const Points2& chain, bool closed);

}  // namespace ripstop
