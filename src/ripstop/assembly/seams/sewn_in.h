#pragma once

#include <vector>

#include "ripstop/assembly/seams/run_claims.h"
#include "ripstop/assembly/seams/seam_lengths.h"

namespace ripstop {

/// A further sheet along a seam of two others. Chain a is the sheet's; chain b is the side of the seam that runs
/// in the opposite direction.
struct SewnInRun {
    Run run;
    std::size_t seam;  ///< index of the seam it lies in, among those of two sheets
    bool on_side_b;    ///< whether chain b is side b of that seam
    RunEnds ends;
};

/// The further sheets: runs of `opposed` that lie on seams and are not sewn, each along one seam as far as both
/// go. The longest comes first. They end where either chain ends, or where the two share a vertex and separate.
/// `places` belongs to the seams of two sheets. What is found is claimed.
std::vector<SewnInRun> find_sewn_in(const std::vector<PlacedChain>& chains, const std::vector<Run>& opposed,
                                    const std::vector<RunOnSeam>& places, double tolerance, RunClaims& claims);

/// The seam record of a further sheet. Its parts have the lengths of the seam it lies in: edge by edge if both
/// have the same vertices, else by projection. So all sheets on an edge have the same length.
Seam make_sewn_in(const std::vector<PlacedChain>& chains, const SewnInRun& sheet, const std::vector<Seam>& seams,
                  const RunOnSeam& place);

}  // namespace ripstop
