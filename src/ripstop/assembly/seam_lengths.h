#pragma once

#include <vector>

#include "ripstop/assembly/find_seams.h"
#include "ripstop/assembly/seam_runs.h"

namespace ripstop {

/// The seam of a run, both sides measured on one curve (`find_seams`); without an id.
Seam make_seam(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

/// Where a run begins and ends on each side: at a vertex where there is one within the tolerance. Loops go on past theirs.
struct RunEnds {
    double start_a, end_a;  ///< ascending
    double start_b, end_b;  ///< ascending; b's start lies beside a's end
};
RunEnds ends_of(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

/// The chains of a seam, and from where to where.
struct RunOnSeam {
    int a, b;
    RunEnds ends;
};

/// What no seam covers of each tile's boundary.
std::vector<LooseRun> loose_runs_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                    const std::vector<RunOnSeam>& runs, double tolerance);

/// `Tile::curve_lengths` of every tile: the parts on seams and the chord's share of what is on none. Empty where each edge
/// has the length of its chord.
std::vector<Eigen::VectorXd> curve_lengths_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                              const std::vector<Seam>& seams, const std::vector<RunOnSeam>& runs,
                                              double tolerance);

}  // namespace ripstop
