#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// An SVG picture of how the edges of neighbours fit. It shows every flat outline with its name, at one scale, in rows
/// in the order of the input. Each sewn edge is coloured by the distance between the two sides (linear between the
/// notches), in mm per metre of seam, up to the tolerance; beyond the tolerance the line is also thicker, so it can be
/// recognised without colour. If there is space, the picture states by how many mm an edge is longer than its mate.
/// Unsewn edges are grey. Empty for a plan without seams.
std::string seam_picture(const CutPlan& plan);

}  // namespace ripstop
