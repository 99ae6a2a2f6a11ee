#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/zigzag.h"

namespace ripstop {

/// Measures the zigzags of a tile on the curve that each stands for (`FairCurve`): its length in space, including the
/// compensation of the edges along it, and the length of its image on the cloth. Also measures the area of the tile
/// inside all curves, as polygons through the same vertices on both. Empty if the tile was not flattened.
/// O(#boundary).
std::vector<ZigzagWalk> walk_zigzags(const Tile& tile, const Points2& flat, const std::vector<Zigzag>& zigzags);

/// Adds the finding `zigzag` to a tile if a curve misses its length by more than the length tolerance; value and
/// limit in %. There is no waiver for a matching mate: teeth that fold alike on both sides give a seam of another
/// length than drawn.
void judge_zigzags(const Tile& tile, const std::vector<ZigzagWalk>& walks, const Tolerances& tolerances,
                   Verdict& verdict);

/// Finds, measures and judges the zigzags of a whole plan. Requires that its tiles are judged.
void judge_zigzags(CutPlan& plan);

}  // namespace ripstop
