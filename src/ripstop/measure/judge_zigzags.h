#pragma once

#include <vector>

#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/tile/zigzag.h"

namespace ripstop {

/// Measures the zigzags of a tile by the curve that each stands for (`FairCurve`): its length in space, times what the
/// compensation adds to the edges along it, against that of its image on the cloth; and the area that the tile has
/// within all of them, as polygons through the same vertices on both. Nothing where the tile was not flattened.
/// O(#boundary).
std::vector<ZigzagWalk> walk_zigzags(const Tile& tile, const Points2& flat, const std::vector<Zigzag>& zigzags);

/// A curve off its length by more than the tolerance on lengths is a finding of its tile, `zigzag`: value and limit in
/// %. No mate forgives it: teeth that fold alike on both sides are sewn to a seam of another length than was drawn.
void judge_zigzags(const Tile& tile, const std::vector<ZigzagWalk>& walks, const Tolerances& tolerances,
                   Verdict& verdict);

/// Finds, measures and judges those of a whole plan whose tiles are judged.
void judge_zigzags(CutPlan& plan);

}  // namespace ripstop
