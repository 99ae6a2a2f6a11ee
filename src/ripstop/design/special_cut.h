#pragma once

#include "ripstop/design/special_surface.h"

namespace ripstop {

/// Cuts the surface along every crease, sector seam, ring seam and the mouth, and says of each triangle which cell of the
/// body it lies in. New vertices lie on the body and on their curves; no triangle lies on both sides of a curve. Triangles may
/// come out as thin as they like. Requires vertices on the body, one of them at each pole (`set_poles`).
void cut_into_cells(WorkSurface& surface, const SpecialBody& body);

/// Moves the vertex nearest to each pole that shows onto it, and fixes it.
void set_poles(WorkSurface& surface, const SpecialBody& body);

}  // namespace ripstop
