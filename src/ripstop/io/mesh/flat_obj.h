#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// flat/NAME.obj: the tile in space (`v`, metres) and on the cloth (`vt`, metres), one each a vertex, and its triangles
/// as `f v/vt` in the order of the input. Numbers read back to the same doubles.
std::string flat_obj(const FlatTile& tile);

}  // namespace ripstop
