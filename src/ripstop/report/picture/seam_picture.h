#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// An SVG picture of how the edges of neighbours fit, for people: every flat outline at one scale, row after row in the
/// order of the input, its name in it; each sewn edge in the colour of how far the two sides are apart there (between
/// the notches in proportion), in mm per metre of seam, pinned to the tolerance; beyond it the line is also thicker, so
/// that the colour is not needed. Beside an edge with room for it: by how many mm it is longer than its mate. Edges
/// that are sewn to nothing are grey. Empty for a plan without seams.
std::string seam_picture(const CutPlan& plan);

}  // namespace ripstop
