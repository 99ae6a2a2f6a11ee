#pragma once

#include <optional>
#include <vector>

#include "ripstop/assembly/seams/chain_curve.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// A chain among all chains of an envelope, with its curve.
struct PlacedChain {
    int tile = 0, chain = 0;
    int first_edge = 0;      ///< the place of the chain's first edge in the tile's boundary
    int boundary_edges = 0;  ///< of the tile
    ChainCurve curve;
};

/// Every chain of every tile, in their order. In parallel; O(#V).
std::vector<PlacedChain> place_chains(const std::vector<Tile>& tiles);

/// A vertex of one of two chains and the place of the other nearest to it.
struct Touch {
    int a = 0, b = 0;           ///< chains, a <= b
    double at_a = 0, at_b = 0;  ///< one of them a whole number, the vertex; at_a <= at_b where a = b
    double distance = 0;        ///< [m]
    double slack = 0;           ///< what the curve may be off at this place for want of vertices [m]
    bool same_way = false;      ///< the two chains run the same way, as those of a seam never do
};

/// A place where two chains run beside each other.
struct Run {
    int a = 0, b = 0;
    bool same_way = false;
    std::vector<Touch> touches;  ///< at_a ascending; at_b descending, or ascending where they run the same way
    double start_a() const { return touches.front().at_a; }
    double end_a() const { return touches.back().at_a; }
    double low_b = 0, high_b = 0;
    double length = 0;  ///< the shorter of the two sides [m]
    double gap = 0;     ///< largest distance [m]
    double turn = 0;    ///< its turn among the runs (`order_sheets`): the length of the longest it competes with [m]
    double rank = 0;    ///< and among those, lower first
};

/// How far from each other two chains are looked at: twenty tolerances, or 5 % of the shorter one but no more than a
/// fifth of the median chain, so that one huge tile does not meet everything.
struct Reach {
    double least = 0, most = 0;  ///< [m]
    double operator()(const ChainCurve& a, const ChainCurve& b) const;
};
Reach make_reach(const std::vector<PlacedChain>& chains, double tolerance);

/// For each vertex of each chain the nearest place of every other chain within `reach`, once running against it and
/// once running the same way; where a chain folds back on itself, the fold. Sorted by a, b, same_way, at_a, so the
/// same on any number of threads. A grid of cells over all edges: O(#V) for edges of like length.
std::vector<Touch> find_touches(const std::vector<PlacedChain>& chains, double tolerance);

/// Joins the touches of two chains into runs: from one to the next there is no vertex of either chain between. Takes
/// one pair of chains and direction; runs of no length are left out.
std::vector<Run> join_touches(const std::vector<PlacedChain>& chains, std::vector<Touch> touches, double tolerance);

/// The part of a run between two places of its chain b, or of chain a: its ends lie between touches where they must.
/// Nothing where the run does not reach there.
std::optional<Run> cut_run(const std::vector<PlacedChain>& chains, const Run& run, bool by_b, double low, double high);

/// The same run seen from its other chain: a and b change places.
Run seen_from_b(const Run& run);

/// Which of the runs end as seams do, at both ends: where either chain ends, at the tip of a dart, where another of
/// them begins, all round a loop, or at the last of vertices that coincide; or where the two chains come together
/// again, at the next run on both no further off than the two are long, or at a corner of both no further off than
/// twice its length. Edges that merely cross leave each other in mid-chain. `touches` as `find_touches` returns them.
std::vector<bool> find_well_ended(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches,
                                  const std::vector<Run>& runs, double tolerance);

}  // namespace ripstop
