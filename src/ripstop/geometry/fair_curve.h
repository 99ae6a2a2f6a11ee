#pragma once

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A chain of edges on a surface, laid out in the plane with its own lengths and turns: what it looks like to one who
/// walks along it. On a surface that can be unrolled it is the unrolled chain.
struct ChainLayout {
    Eigen::VectorXd lengths;  ///< of the edges [m]; of a closed chain as many as vertices, the last back to the first
    Eigen::VectorXd
        turns;  ///< at the vertices, positive to the left [rad]; at the ends of an open chain without meaning
    bool closed = false;
};

/// The layout of a chain that lies in the plane (#N x 2); a closed one does not repeat its first vertex.
ChainLayout layout_of(const Points2& chain, bool closed);

/// What a fair curve does to its chain.
struct FairLine {
    double length = 0;        ///< of the smooth curve through its vertices [m]
    double area_on_left = 0;  ///< between the chain and it, positive where it lies to the left [m2]
    Points2 moves;            ///< #N x 2: from each vertex to its place on it, along the chain and to its left [m]
};

/// The curve that a chain of edges stands for where it zigzags from vertex to vertex, as a cut along the edges of a
/// mesh does. Of all curves f, with the laid out vertices p at the stations s, it is the one with the least
///
///     sum_i w_i |f_i - p_i|^2 + r^6 integral |f''' + k^2 f'|^2 ds        w: half the two edges beside a vertex
///
/// and once more of what that leaves (p - f), so that slow bends lose nothing. The second term is zero for a straight
/// line and for a circle of curvature k: it is the smoothing spline in tension of order three (Reinsch 1967 with
/// another operator), which damps what is shorter than some 2 pi r and keeps what is longer. r is three mean edges.
///
/// Stations are the arc length of a first fit, not the chain's: teeth that hardly advance have hardly any; k is the
/// turning of that fit over its length, of each image of the chain its own. An open chain keeps its two ends; a closed
/// one is walked round once and a little more, where its ends are free, and what lies beyond its round does not count.
/// So a chain and its image on the cloth are smoothed alike, vertex by vertex, and where the cloth has the chain's own
/// lengths and turns their curves are equally long to rounding.
class FairCurve {
  public:
    /// Needs four vertices, closed six, and no edge of length 0. O(#N).
    explicit FairCurve(const ChainLayout& chain);

    const FairLine& line() const { return line_; }
    FairLine of_image(const ChainLayout& image) const;

  private:
    double reach_ = 0, first_reach_ = 0;  ///< r of the second fit and of the first [m]
    Eigen::VectorXd first_,
        steps_;  ///< from each vertex laid out to the next: along the chain, along the first fit [m]
    FairLine line_;
};

/// Where the vertices of a chain in the plane (#N x 2) lie on its fair curve. A closed one stays closed, which the
/// layout of a chain on a surface need not be: so slow waves too are damped that fit into its round.
Points2 fair_points(const Points2& chain, bool closed);

}  // namespace ripstop
