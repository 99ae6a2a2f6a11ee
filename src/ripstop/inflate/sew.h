#pragma once

#include "ripstop/model/flight/rigging.h"
#include "ripstop/model/flight/sewn_envelope.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/symmetry.h"

namespace ripstop {

/// What the cloth is at rest, after it has shrunk by what it was cut longer for (`Compensation::warp`, `weft`).
enum class RestState {
    as_cut,     ///< as each piece lies on the cloth
    as_wanted,  ///< as if every triangle had been cut as it is to be (`target_triangles`), without any error
    as_drawn,   ///< as if every triangle had been cut as drawn
};

/// What `sew` adds to the pieces: tapes and ropes, symmetry, and the rest state.
struct SewOptions {
    Rigging rigging = {};
    Symmetry symmetry = {};  ///< none unless given
    RestState rest = RestState::as_cut;
    double stiffer = 1;  ///< cloth and tapes are so much stiffer than they are
};

/// Sews the flat pieces of a plan into one rest state: the two sides of each seam are one line in space, the same place
/// of the seam's curve on both (where the notches lie), so unequal lengths become ease. Sides that are meshed
/// differently, and T-junctions, hang on the edges they meet. Diaphragms hang on the skin where their edge lies as
/// drawn. A further sheet in a seam (`Seam::into`) is one line with it, and has gas on both sides as a diaphragm has
/// (`find_inner_sheets`). Load tapes follow the seams that take one, shorter than the seam's curve by the rigging's
/// `foreshortening` and, but for `RestState::as_drawn`, by the plan's `tape_factors`. Openings: the lowest is the
/// mouth, the highest the crown.
///
/// Throws InputError for tiles without flat positions or with flipped triangles (named), a diaphragm that is no tile or
/// touches nothing, a tie that ends off the envelope, and where nothing could hold the envelope. O(#V).
SewnEnvelope sew(const CutPlan& plan, const SewOptions& options = {});

/// The triangles of a tile's cloth at rest: edges b - a and c - a along warp and weft [m].
std::vector<Mat22> cloth_at_rest(const FlatTile& tile, RestState rest);

/// Without symmetry: each tile for itself.
Symmetry no_symmetry(const CutPlan& plan);

}  // namespace ripstop
