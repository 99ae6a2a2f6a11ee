#pragma once

#include <compare>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"

namespace ripstop {

/// What of a plan fails; fewer tiles go before fewer seams.
struct Failing {
    int tiles = 0;  ///< that cannot be made
    int seams = 0;  ///< whose sides disagree, or whose length the meshes leave open by more than it may err

    auto operator<=>(const Failing&) const = default;
};

/// Counts what fails of the tiles and seams of a plan that is judged.
Failing count_failing(const CutPlan& plan);

/// Remeshing may make nothing worse than it is on the meshes of the file. Where a remeshed tile or a seam of one fails,
/// flattens `input.drawn` too, with the same options, and takes that plan and that envelope where less fails on them;
/// `input` has a remark then that says so, its last, instead of those on remeshing. For `RemeshMode::automatic`: who
/// asks for a length keeps the meshes of that length.
///
/// `plan`: as `flatten_envelope` made it of `input.envelope`. Returns whether the drawn meshes were taken. Costs one
/// more flattening where something fails, else nothing.
bool prefer_own_meshes(CutPlan& plan, EnvelopeInput& input, const FlattenOptions& options);

}  // namespace ripstop
