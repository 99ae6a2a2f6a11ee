#pragma once

#include <string>
#include <vector>

#include "ripstop/io/rhino/rhino_placing.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// What the designer said of an object in its place: `layer` (its own, whole path), `group`, and user text by key, its
/// own before that of the blocks it is part of, but the `tile` it is called by. A `warp` is turned with the blocks
/// around whoever has it.
Attributes rhino_attributes(const RhinoPlaced& placed, const RhinoTables& tables);

/// A name for each surface, none twice: the user text `tile` of a block's instance that holds this surface alone, after
/// the path of the blocks around that; else its own user text `tile`, else the object's name, after the path of the
/// blocks it is part of. Without either: the path alone for the only surface of a block, else the path with a number;
/// outside of blocks the last part of the layer for the only surface on it, else STEM_01, STEM_02, … Of equal names
/// each gets its layer in front, and what is equal even so a number behind: `_2`, `_3`, …
std::vector<std::string> rhino_surface_names(const std::vector<RhinoPlaced>& surfaces,
                                             const std::vector<Attributes>& attributes, const std::string& stem);

/// The same for what is no surface: `fallback` with a number where there is no name; names may come twice.
std::vector<std::string> rhino_other_names(const std::vector<RhinoPlaced>& objects, const std::string& fallback);

}  // namespace ripstop
