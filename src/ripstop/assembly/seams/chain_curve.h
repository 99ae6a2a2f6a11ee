#pragma once

#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The smooth curve through the vertices of a chain: a cubic an edge, with tangents of the circle through three
/// vertices in a row, and at the chain's ends, and where it turns by more than `corner_turn` in space, of the circle of
/// the last three.
///
///     T_i ~ b u_a + a u_b        a, b the lengths of the edges before and after, u their directions
///     c'(0) = m T_i,  c'(1) = m T_(i+1),  m = chord / cos^2(phi / 4),  phi the angle from T_i to T_(i+1)
///
/// Of a circle it has the right tangents at any spacing and a length true to sixth order; of any smooth curve, to
/// fourth. A place on it is a number `at`: edge k from k to k + 1. A chain without ends goes on past them.
struct ChainCurve {
    Points3 points;                    ///< #E + 1 [m]
    Points3 start_slopes, end_slopes;  ///< #E: c'(0) and c'(1) of each edge [m]
    Eigen::VectorXd stations;          ///< #E + 1: arc length to each vertex [m]
    bool closed = false;               ///< it ends where it starts, and no corner is there
    double unseen_turn = 0;            ///< of a chain of one edge: by how much the surface turns along it [rad]; else 0

    int edge_count() const { return static_cast<int>(stations.size()) - 1; }
    double length() const { return stations[edge_count()]; }
};

/// O(#E); of a chain of one edge O(#F).
ChainCurve make_chain_curve(const Tile& tile, const Chain& chain);

/// Point, direction and arc length at a place of the curve.
Vec3 point_at(const ChainCurve& curve, double at);
Vec3 direction_at(const ChainCurve& curve, double at);  ///< unit length
double station_at(const ChainCurve& curve, double at);  ///< arc length from the start, monotone in `at` [m]

/// The breaks of a run: its ends and the vertices between, ascending.
std::vector<double> breaks_between(double low, double high);

/// By how much an edge's cubic turns [rad].
double turn_of_edge(const ChainCurve& curve, int edge);
double chord_of_edge(const ChainCurve& curve, int edge);

/// The nearest point of one edge.
struct FootPoint {
    double at = 0;
    double distance = 0;  ///< [m]
};
FootPoint foot_on_edge(const ChainCurve& curve, int edge, const Vec3& point);

}  // namespace ripstop
