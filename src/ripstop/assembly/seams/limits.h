#pragma once

/// Limits that every search for seams shares.
namespace ripstop {

inline constexpr double shortest_run = 4;        ///< tolerances: chains that meet at a corner touch for less
inline constexpr double near_end = 2;            ///< tolerances: an end this far from another is at it
inline constexpr double one_vertex = 0.05;       ///< of an edge: vertices nearer than this are one
inline constexpr double fair_share_low = 0.8;    ///< an edge projected on the common curve keeps about its own length,
inline constexpr double fair_share_high = 1.25;  ///< else the sides lie too unevenly for it and share the length evenly

}  // namespace ripstop
