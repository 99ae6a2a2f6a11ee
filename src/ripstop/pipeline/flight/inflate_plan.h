#pragma once

#include "ripstop/inflate/inflate.h"

namespace ripstop {

/// What `inflate_plan` fills a plan with, and what it works out beside the shape.
struct InflatePlanOptions {
    LoadCase load = {};
    Rigging rigging = {};
    bool use_symmetry = true;  ///< compute one of equal sectors
    bool find_causes = true;   ///< inflate it twice more, cut without error, to tell the causes of a deviation apart
    int threads = 0;
    Progress progress = {};
};

/// Sews, inflates and compares a plan (`inflate`), in one sector where it has equal ones (`find_symmetry`), and tells
/// the causes of what it is off apart. Throws InputError as `inflate` does.
Inflated inflate_plan(const CutPlan& plan, const InflatePlanOptions& options);

}  // namespace ripstop
