#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/seam_type_use.h"

namespace ripstop {

/// The seam allowance along each boundary edge of each tile [m] (#boundary per tile): that of the edge's seam, or of
/// the chain's finish if it is in no seam. Takes the wider one if several apply, or if only part of the edge is in a
/// seam. O(seams + boundary edges).
std::vector<Eigen::VectorXd> edge_allowances(const CutPlan& plan);

/// The length of each chain of each tile that is in no seam [m] (#chains per tile), as drawn. Lengths below a
/// hundredth of a millimetre per edge are ignored. O(seams + boundary edges).
std::vector<Eigen::VectorXd> free_lengths(const CutPlan& plan);
std::vector<Eigen::VectorXd> free_lengths(const Envelope& envelope);

/// The seam types in use, each once, in order of appearance, seams first. Types of the same name with different
/// allowances are listed separately.
std::vector<SeamTypeUse> seam_types_used(const CutPlan& plan);
std::vector<SeamTypeUse> seam_types_used(const Envelope& envelope);

}  // namespace ripstop
