#pragma once

#include <vector>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {

/// The seam of a run, with both sides measured on one curve (`find_seams`); the id is left empty.
Seam make_seam(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

/// The ends of a run on each side, moved to a vertex within the tolerance.
RunEnds ends_of(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

/// True if both sides of a seam have the same vertices, within 1e-6 of its length.
bool conforms(const ChainCurve& a, const ChainCurve& b, const RunEnds& ends);

/// The uncertainty of a curve's smooth length between two places (`find_seams`) [m].
double open_length(const ChainCurve& curve, double low, double high);

/// The chains of a seam and its ends on them.
struct RunOnSeam {
    int a, b;
    RunEnds ends;
};

/// The parts of each tile's boundary that no seam covers.
std::vector<LooseRun> loose_runs_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                    const std::vector<RunOnSeam>& runs, double tolerance);

/// `Tile::curve_lengths` of every tile: the parts on seams, plus the chord for the parts on none. Empty if every
/// edge has the length of its chord.
std::vector<Eigen::VectorXd> curve_lengths_of(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                              const std::vector<Seam>& seams, const std::vector<RunOnSeam>& runs,
                                              double tolerance);

}  // namespace ripstop
