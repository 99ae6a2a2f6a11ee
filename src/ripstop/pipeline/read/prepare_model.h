#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/plan/envelope_check.h"
#include "ripstop/model/project/project.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

// What is done to a file's model before it is made tiles.

/// Mends the meshes of its surfaces (`mend_mesh`), `tip_width` in the file's unit. Drawn positions and warps go along,
/// and are dropped where vertices that become one differ in them. A tip whose vertices are drawn apart is a dart and
/// kept. Returns a sentence for each kind of thing mended, with how many, the surfaces and the place, in the file's
/// unit. In parallel, O(#F log #F).
std::vector<std::string> mend_surfaces(CadModel& model, double tip_width, int threads = 0);

/// Where coordinates are counted from instead of the file's origin, in the file's unit: whole numbers, along each axis
/// on which the model lies further off than a thousand of its sizes, as on a map; zero on the others. Nothing is lost
/// by it: whole numbers are taken off exactly. Products of coordinates, of which areas and volumes are sums, would lose
/// six digits and more.
Vec3 far_origin(const CadModel& model);

/// The model and the project with all their points moved by -`origin`, which is in the file's unit, `metres` long.
void count_from(const Vec3& origin, CadModel& model);
void count_from(const Vec3& origin, double metres, Project& project);

}  // namespace ripstop
