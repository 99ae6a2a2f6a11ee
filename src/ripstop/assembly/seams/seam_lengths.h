#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {

/// The seam of a run, both sides measured on one curve (`find_seams`); without an id.
Seam make_seam(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

/// Where a run begins and ends on each side: at a vertex where there is one within the tolerance.
RunEnds ends_of(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

/// Do both sides of a seam have the same vertices, within 1e-6 of its length?
bool conforms(const ChainCurve& a, const ChainCurve& b, const RunEnds& ends);

/// What the vertices leave open of a curve's smooth length between two places (`find_seams`) [m].
double open_length(const ChainCurve& curve, double low, double high);

/// The chains of a seam, and from where to where.
struct RunOnSeam {
    int a, b;
    RunEnds ends;
};

/// What no seam covers of each tile's boundary.
std::vector<LooseRun> loose_runs_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                    const std::vector<RunOnSeam>& runs, double tolerance);

/// `Tile::curve_lengths` of every tile: the parts on seams and the chord's share of what is on none. Empty where each
/// edge has the length of its chord.
std::vector<Eigen::VectorXd> curve_lengths_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                              const std::vector<Seam>& seams, const std::vector<RunOnSeam>& runs,
                                              double tolerance);

}  // namespace ripstop
