#pragma once

#include "ripstop/model/flight/rigging.h"
#include "ripstop/model/flight/sewn_envelope.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/symmetry.h"

namespace ripstop {

/// The rest state of the cloth, after it has shrunk by the compensation (`Compensation::warp`, `weft`).
enum class RestState {
    as_cut,     ///< as each piece is flattened
    as_wanted,  ///< as if every triangle had been cut to its target (`target_triangles`), without error
    as_drawn,   ///< as if every triangle had been cut as drawn
};

/// Options of `sew`: rigging, symmetry and rest state.
struct SewOptions {
    Rigging rigging = {};
    Symmetry symmetry = {};  ///< default: none
    RestState rest = RestState::as_cut;
    double stiffer = 1;  ///< factor on the stiffness of cloth and tapes
};

/// Sews the flat pieces of a plan to one envelope. The two sides of each seam become one line in space, and the same
/// place of the seam's curve (a notch) is one point, so unequal lengths become ease. Sides with different meshes, and
/// T-junctions, depend on the edges they meet. Diaphragms depend on the skin where their edge is drawn on it. An
/// additional sheet in a seam (`Seam::into`) coincides with it, and like a diaphragm has gas on both sides
/// (`find_inner_sheets`). Load tapes follow the seams that have one. They are shorter than the seam's curve by the
/// rigging's `foreshortening` and, except for `RestState::as_drawn`, scaled by the plan's `tape_factors`. The lowest
/// opening is the mouth, the highest the crown.
///
/// Throws InputError for tiles without flat positions or with flipped triangles (named), for a diaphragm that is not
/// a tile or touches nothing, for a tie that ends off the envelope, and if nothing could hold the envelope. O(#V).
SewnEnvelope sew(const CutPlan& plan, const SewOptions& options = {});

/// The triangles of a tile's cloth at rest: edges b - a and c - a along warp and weft [m].
std::vector<Mat22> cloth_at_rest(const FlatTile& tile, RestState rest);

/// The symmetry of a plan without sectors: each tile on its own.
Symmetry no_symmetry(const CutPlan& plan);

}  // namespace ripstop
