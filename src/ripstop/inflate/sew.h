#pragma once

#include "ripstop/model/cut_plan.h"
#include "ripstop/model/rigging.h"
#include "ripstop/model/sewn_envelope.h"
#include "ripstop/model/symmetry.h"

namespace ripstop {

/// Sews the flat pieces of a plan into one rest state: each triangle is at rest as it lies on the cloth, and the two sides of each seam are
/// one line in space, the same place of the seam's curve on both (where the notches lie), so unequal lengths become ease. Sides
/// that are meshed differently, and T-junctions, hang on the edges they meet. Diaphragms hang on the skin where their edge
/// lies as drawn. Load tapes follow the seams that take one, shorter than the seam's curve by `foreshortening`
/// and by `tape_factors` (one a seam, a ratio; all 1 where empty). Openings: the lowest is the mouth, the highest the crown.
///
/// Throws InputError for tiles without flat positions or with flipped triangles (named), a diaphragm that is no tile or
/// touches nothing, a tie that ends off the envelope, and where nothing could hold the envelope. O(#V).
SewnEnvelope sew(const CutPlan& plan, const Rigging& rigging, const Symmetry& symmetry = {},
                 const std::vector<double>& tape_factors = {});

/// Without symmetry: each tile for itself.
Symmetry no_symmetry(const CutPlan& plan);

}  // namespace ripstop
