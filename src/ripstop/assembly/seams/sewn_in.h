#pragma once

#include <vector>

#include "ripstop/assembly/seams/run_claims.h"
#include "ripstop/assembly/seams/seam_lengths.h"

namespace ripstop {

/// A further sheet along the seam of two others: chain a the sheet's, chain b that of the seam's side which runs
/// against it.
struct SewnInRun {
    Run run;
    std::size_t seam;  ///< the seam it lies in, in the list of those of two sheets
    bool on_side_b;    ///< b is that seam's side b
    RunEnds ends;
};

/// What of `opposed` lies on seams and is sewn to nothing itself: further sheets, each along one seam as far as both
/// go. They are taken longest first, and end where either does, or where the two share a vertex and part. `seams` and
/// `places` are those of two sheets; what is taken is claimed.
std::vector<SewnInRun> find_sewn_in(const std::vector<PlacedChain>& chains, const std::vector<Run>& opposed,
                                    const std::vector<RunOnSeam>& places, double tolerance, RunClaims& claims);

/// The record of a further sheet. Its parts are as long as those of the seam it lies in, edge by edge where both have
/// the same vertices, else by projection; so all sheets on the edge have one length.
Seam make_sewn_in(const std::vector<PlacedChain>& chains, const SewnInRun& sheet, const std::vector<Seam>& seams,
                  const RunOnSeam& place);

}  // namespace ripstop
