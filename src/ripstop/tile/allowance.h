#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// How wide the cloth is cut beyond the sew line along each boundary edge of each tile [m] (#boundary a tile): the
/// allowance of the seam the edge belongs to, of the chain's finish where it belongs to none, and the wider where it
/// belongs to several, or to a seam with only a part of it. O(seams + boundary edges).
std::vector<Eigen::VectorXd> edge_allowances(const CutPlan& plan);

/// How much of each chain of each tile is in no seam [m] (#chains a tile), as drawn; less than a hundredth of a
/// millimetre of an edge counts as none. O(seams + boundary edges).
std::vector<Eigen::VectorXd> free_lengths(const CutPlan& plan);
std::vector<Eigen::VectorXd> free_lengths(const Envelope& envelope);

/// A type and how much is sewn of it.
struct SeamTypeUse {
    SeamType type;
    int seams = 0, free_edges = 0;  ///< free edges: chains that are in no seam, or not wholly
    double length = 0;              ///< of all of them [m]
};

/// The types that are sewn, each once, in the order in which they come: seams first. Types of one name with different
/// allowances stand apart.
std::vector<SeamTypeUse> seam_types_used(const CutPlan& plan);
std::vector<SeamTypeUse> seam_types_used(const Envelope& envelope);

}  // namespace ripstop
