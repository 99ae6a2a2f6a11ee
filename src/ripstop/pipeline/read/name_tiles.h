#pragma once

#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// Calls the surfaces of a file what the project's entries with `source` or `at` call them; points in the file's own
/// unit.
///
/// `at` means the surface nearest to the point, which must lie within a tenth of that surface's size of it: a point
/// farther off is one of another unit or another drawing. Throws InputError naming the entry where its source is called
/// like no surface or like several, where its point is far from every surface or as near to two, where two entries mean
/// one surface, and where a name would then stand twice. O(#surfaces + #F of the surfaces whose box is near) a point.
void name_tiles(CadModel& model, const Project& project);

}  // namespace ripstop
