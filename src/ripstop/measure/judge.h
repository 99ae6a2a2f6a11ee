#pragma once

#include "ripstop/measure/bounds.h"
#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The paper's tolerances, with the strain and shear that `fabric` stands.
Tolerances tolerances_of(const Fabric& fabric);

/// Can the tile be made as drawn? Every reason against it is a finding with its value, limit and place:
///
/// `isoperimetric`, `stretch_bound` (impossible for any flattening); `unsolved` (the method gave nothing, or is not at
/// rest), `uncertified` (its certificate does not show a strict minimum with exact edges), `flipped`, `overlap`,
/// `outline`, `area`, `perimeter`, `chain` (off by more than a plotter's step too, 0.025 mm), `warp_strain`,
/// `weft_strain`, `shear`. Values and limits are in % and degrees, counts and ratios as they are.
Verdict judge(const Tile& tile, const Bounds& bounds, const Flattening& flattening, const Accuracy& accuracy,
              const Tolerances& tolerances);

}  // namespace ripstop
