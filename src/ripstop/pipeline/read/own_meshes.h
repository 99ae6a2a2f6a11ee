#pragma once

#include <compare>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/pipeline/flatten/flatten_envelope.h"
#include "ripstop/pipeline/read/read_envelope.h"

namespace ripstop {

/// The numbers of failing tiles and seams of a plan. Plans are ordered by tiles first, then by seams.
struct Failing {
    int tiles = 0;  ///< tiles that cannot be made
    int seams = 0;  ///< seams whose sides disagree, or whose length is uncertain by more than the tolerance

    auto operator<=>(const Failing&) const = default;
};

/// Counts the failing tiles and seams of a judged plan.
Failing count_failing(const CutPlan& plan);

/// Ensures that remeshing makes nothing worse. If a remeshed tile or one of its seams fails, flattens `input.drawn`
/// with the same options too, and takes that plan and envelope if fewer of them fail there. The last remark of `input`
/// then says so, in place of the remarks on remeshing. For `RemeshMode::automatic`: an edge length that the user asked
/// for is kept.
///
/// `plan`: the result of `flatten_envelope` for `input.envelope`. Returns whether the drawn meshes were taken. Costs
/// one more flattening if something fails, else nothing.
bool prefer_own_meshes(CutPlan& plan, EnvelopeInput& input, const FlattenOptions& options);

}  // namespace ripstop
