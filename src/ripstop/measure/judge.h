#pragma once

#include "ripstop/measure/measure_bounds.h"
#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The paper's tolerances with the strain and shear limits of `fabric`.
Tolerances tolerances_of(const Fabric& fabric);

/// Judges whether the tile can be made as drawn. Every reason against it is a finding with value, limit and place.
/// The codes: `isoperimetric`, `stretch_bound` (impossible for any flattening); `unsolved` (the method returned
/// nothing, or did not converge), `uncertified` (its certificate shows no strict minimum with exact edges),
/// `flipped`, `overlap`, `outline`, `area`, `perimeter`, `chain` (only if also off by more than a plotter step,
/// 0.025 mm), `warp_strain`, `weft_strain`, `shear`. Values and limits are in % and degrees, except counts and
/// ratios.
Verdict judge(const Tile& tile, const Bounds& bounds, const Flattening& flattening, const Accuracy& accuracy,
              const Tolerances& tolerances);

}  // namespace ripstop
