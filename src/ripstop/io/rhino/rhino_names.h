#pragma once

#include <string>
#include <vector>

#include "ripstop/io/rhino/rhino_placing.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What the designer said about a placed object: `layer` (its own, full path), `group`, and user text by key. The
/// object's own text overrides that of the blocks around it. The user text `tile` that names the object is left
/// out. A `warp` is rotated by the blocks around its owner.
Attributes rhino_attributes(const RhinoPlaced& placed, const RhinoTables& tables);

/// A unique name for each surface. The first of these that exists gives it:
///
/// 1. the user text `tile` of a block instance that holds only this surface, after the path of the blocks around it;
/// 2. the surface's own user text `tile`, then the object's name, after the path of the blocks around it;
/// 3. in a block: the path, if the block has one surface, else the path with a number;
/// 4. outside of blocks: the last part of the layer's path, if the layer has one surface, else STEM_01, STEM_02, …
///
/// Equal names get their layer in front. Names that are still equal get a number at the end: `_2`, `_3`, …
std::vector<std::string> rhino_surface_names(const std::vector<RhinoPlaced>& surfaces,
                                             const std::vector<Attributes>& attributes, const std::string& stem);

/// Names for objects that are not surfaces: `fallback` with a number if an object has no name. Names may repeat.
std::vector<std::string> rhino_other_names(const std::vector<RhinoPlaced>& objects, const std::string& fallback);

}  // namespace ripstop
