#pragma once

#include <optional>

#include "ripstop/io/rhino/rhino_tables.h"

namespace ripstop {

/// A curve object as a polyline: the points of a line or a polyline as they are, of an arc or a NURBS curve so many
/// that no chord lies further than 0.1 % of the curve's size away from it, of a joined curve those of its parts.
/// Nothing for a class of curves this does not know. Throws InputError where the data is cut short or no curve
/// (`called` names it).
std::optional<Points3> read_rhino_curve(const RhinoClass& object, const std::string& called);

}  // namespace ripstop
