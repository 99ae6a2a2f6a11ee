#pragma once

#include "ripstop/inflate/inflate.h"

namespace ripstop {

/// Options of `inflate_plan`: how the plan is filled, and what is computed besides the shape.
struct InflatePlanOptions {
    LoadCase load = {};
    Rigging rigging = {};
    bool use_symmetry = true;  ///< compute only one of equal sectors
    bool find_causes = true;   ///< inflate twice more, cut without error, to separate the causes of the deviation
    int threads = 0;
    Progress progress = {};
};

/// Sews, inflates and compares a plan (`inflate`), reduced to one sector if its sectors are equal (`find_symmetry`),
/// and separates the causes of the deviation. Throws InputError as `inflate` does.
Inflated inflate_plan(const CutPlan& plan, const InflatePlanOptions& options);

}  // namespace ripstop
