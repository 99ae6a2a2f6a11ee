#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

// Steps that prepare a file's model before tiles are made of it.

/// Mends the meshes of the model's surfaces (`mend_mesh`), `tip_width` in the file's unit. Drawn positions and warps
/// are kept unless merged vertices differ in them. A tip whose vertices have different drawn positions is a dart and is
/// kept. Returns a sentence for each kind of repair, with the count, the surfaces and the place, in the file's unit.
/// Parallel, O(#F log #F).
std::vector<std::string> mend_surfaces(CadModel& model, double tip_width, int threads = 0);

/// A new origin for a model that lies far from the file's origin, as on a map; in the file's unit. The coordinates are
/// whole numbers along each axis on which the model is more than a thousand of its sizes away, and zero on the others.
/// Subtracting whole numbers loses nothing, whereas products of far coordinates, which areas and volumes sum up, would
/// lose six digits or more.
Vec3 far_origin(const CadModel& model);

/// Moves all points of the model and the project by -`origin`, which is in the file's unit of `metres`.
void count_from(const Vec3& origin, CadModel& model);
void count_from(const Vec3& origin, double metres, Project& project);

}  // namespace ripstop
