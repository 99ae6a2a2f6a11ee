#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The text of flat/NAME.obj: for each vertex its position in space (`v`) and on the cloth (`vt`), both in metres,
/// and the triangles as `f v/vt` in the order of the input. The numbers read back as the same doubles.
std::string flat_obj(const FlatTile& tile);

}  // namespace ripstop
