#pragma once

#include <optional>

#include "ripstop/io/rhino/rhino_tables.h"

namespace ripstop {

/// A curve object as a polyline. A line or polyline keeps its points. An arc or NURBS curve gets enough points
/// that no chord is further from it than 0.1 % of the curve's size. A joined curve gets the points of its parts.
/// Returns nothing for an unknown class of curves. Throws InputError, with `called` as the object's name, if the
/// data is cut short or no curve.
std::optional<Points3> read_rhino_curve(const RhinoClass& object, const std::string& called);

}  // namespace ripstop
