#pragma once

#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Renames the surfaces of a file as the project's entries with `source` or `at` say. Points are in the file's own
/// unit.
///
/// `at` selects the surface nearest to the point. The point must lie within a tenth of that surface's size: one farther
/// away comes from another unit or another drawing. Throws InputError naming the entry if its source matches no surface
/// or several, if its point is far from every surface or equally near to two, if two entries select the same surface,
/// or if a name would occur twice. O(#surfaces + #F of the surfaces whose box is near) per point.
void name_tiles(CadModel& model, const Project& project);

}  // namespace ripstop
