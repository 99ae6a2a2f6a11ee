#pragma once

/// Limits that every search for seams shares.
namespace ripstop {

inline constexpr double shortest_run = 4;        ///< tolerances; shorter contacts occur where chains meet at a corner
inline constexpr double near_end = 2;            ///< tolerances; two ends this close coincide
inline constexpr double one_vertex = 0.05;       ///< share of an edge; vertices this close coincide
inline constexpr double fair_share_low = 0.8;    ///< projection may change an edge's length within these factors;
inline constexpr double fair_share_high = 1.25;  ///< otherwise all edges of the side are placed in proportion

}  // namespace ripstop
