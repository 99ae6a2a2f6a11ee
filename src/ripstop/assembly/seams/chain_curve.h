#pragma once

#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// A smooth curve through the vertices of a chain: one cubic per edge. The tangent at a vertex is that of the
/// circle through it and its two neighbours. At the chain's ends, and where it turns in space by more than
/// `corner_turn`, it is that of the circle through the last three vertices.
///
///     T_i ~ b u_a + a u_b        a, b the lengths of the edges before and after, u their directions
///     c'(0) = m T_i,  c'(1) = m T_(i+1),  m = chord / cos^2(phi / 4),  phi the angle from T_i to T_(i+1)
///
/// On a circle the tangents are exact at any spacing, and the length has an error of sixth order; on other smooth
/// curves, of fourth. A place on the curve is a number `at`: edge k covers k to k + 1. On a closed chain, `at` may
/// run beyond the ends.
struct ChainCurve {
    Points3 points;                    ///< #E + 1 [m]
    Points3 start_slopes, end_slopes;  ///< #E: c'(0) and c'(1) of each edge [m]
    Eigen::VectorXd stations;          ///< #E + 1: arc length to each vertex [m]
    bool closed = false;               ///< it ends where it starts, without a corner there
    double unseen_turn = 0;            ///< of a chain with one edge: how much the surface turns along it [rad]; else 0

    int edge_count() const { return static_cast<int>(stations.size()) - 1; }
    double length() const { return stations[edge_count()]; }
};

/// The curve of a chain. O(#E); O(#F) for a chain with one edge.
ChainCurve make_chain_curve(const Tile& tile, const Chain& chain);

/// The point, direction or arc length at a place on the curve.
Vec3 point_at(const ChainCurve& curve, double at);
Vec3 direction_at(const ChainCurve& curve, double at);  ///< unit length
double station_at(const ChainCurve& curve, double at);  ///< arc length from the start [m], monotone in `at`

/// The breaks of a run, ascending: its ends and the vertices between them.
std::vector<double> breaks_between(double low, double high);

/// The angle by which the cubic of an edge turns [rad].
double turn_of_edge(const ChainCurve& curve, int edge);
double chord_of_edge(const ChainCurve& curve, int edge);

/// The closest point on one edge.
struct FootPoint {
    double at = 0;
    double distance = 0;  ///< [m]
};
FootPoint foot_on_edge(const ChainCurve& curve, int edge, const Vec3& point);

}  // namespace ripstop
