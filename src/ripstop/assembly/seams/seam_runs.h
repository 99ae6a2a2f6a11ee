#pragma once

#include <optional>
#include <vector>

#include "ripstop/assembly/seams/chain_curve.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// A chain of an envelope, with its curve.
struct PlacedChain {
    int tile = 0, chain = 0;
    int first_edge = 0;      ///< index of the chain's first edge in the tile's boundary
    int boundary_edges = 0;  ///< number of edges of the tile's boundary
    ChainCurve curve;
};

/// All chains of all tiles, in order. Parallel; O(#V).
std::vector<PlacedChain> place_chains(const std::vector<Tile>& tiles);

/// A vertex of one chain and the closest place on another.
struct Touch {
    int a = 0, b = 0;           ///< chains, a <= b
    double at_a = 0, at_b = 0;  ///< one of them is an integer, the vertex; at_a <= at_b if a = b
    double distance = 0;        ///< [m]
    double slack = 0;           ///< possible error of the curve at this place, because vertices are far apart [m]
    bool same_way = false;      ///< the chains run in the same direction, which those of a seam never do
};

/// A part along which two chains run beside each other.
struct Run {
    int a = 0, b = 0;
    bool same_way = false;
    std::vector<Touch> touches;  ///< at_a ascending; at_b descending, or ascending for equal directions
    double start_a() const { return touches.front().at_a; }
    double end_a() const { return touches.back().at_a; }
    double low_b = 0, high_b = 0;
    double length = 0;  ///< of the shorter side [m]
    double gap = 0;     ///< largest distance [m]
    double turn = 0;    ///< priority (`order_sheets`): the length of the longest run it competes with [m]
    double rank = 0;    ///< and among those, lower ranks come first
};

/// The distance up to which two chains are compared: twenty tolerances, or 5 % of the shorter chain, but at most a
/// fifth of the median chain, so that one huge tile does not meet everything.
struct Reach {
    double least = 0, most = 0;  ///< [m]
    double operator()(const ChainCurve& a, const ChainCurve& b) const;
};
Reach make_reach(const std::vector<PlacedChain>& chains, double tolerance);

/// For each vertex of each chain, the closest place of every other chain within `reach`, once for opposite and
/// once for equal directions. Where a chain folds back on itself, the fold too. Sorted by a, b, same_way and at_a,
/// so the result does not depend on the number of threads. Uses a grid over all edges: O(#V) for edges of similar
/// length.
std::vector<Touch> find_touches(const std::vector<PlacedChain>& chains, double tolerance);

/// Joins the touches of two chains into runs: between neighbouring touches there is no vertex of either chain.
/// Takes one pair of chains and one direction. Runs without length are dropped.
std::vector<Run> join_touches(const std::vector<PlacedChain>& chains, std::vector<Touch> touches, double tolerance);

/// The part of a run between two places of its chain b, or of chain a; its ends may lie between touches. Nothing
/// if the run does not reach that far.
std::optional<Run> cut_run(const std::vector<PlacedChain>& chains, const Run& run, bool by_b, double low, double high);

/// The same run with a and b exchanged.
Run seen_from_b(const Run& run);

/// For each run, whether both its ends are ends of a seam. These are: the end of either chain; the tip of a dart;
/// the start of another such run; a full loop; the last of coinciding vertices. Also a place from which the chains
/// come together again: at the next run on both, no farther off than the two are long, or at a corner of both, no
/// farther off than twice the run's length. Edges that merely cross separate in mid-chain. `touches` is the result
/// of `find_touches`.
std::vector<bool> find_well_ended(const std::vector<PlacedChain>& chains, const std::vector<Touch>& touches,
                                  const std::vector<Run>& runs, double tolerance);

}  // namespace ripstop
