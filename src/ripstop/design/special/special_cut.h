#pragma once

#include "ripstop/design/special/special_surface.h"

namespace ripstop {

/// Cuts the surface along every crease, and says of each triangle which face of the body it lies on. New vertices lie
/// on the body and on their curves; no triangle lies on both sides of one. Triangles may come out as thin as they like,
/// and turned over where the first surface was far from the crease. Requires vertices on the body.
void cut_creases(WorkSurface& surface, const SpecialBody& body);

/// The same along sector seams, ring seams and the mouth: says of each triangle which cell it lies in. Requires
/// `cut_creases`, and a vertex at each pole (`set_poles`).
void cut_seams(WorkSurface& surface, const SpecialBody& body);

/// Moves the vertex nearest to each pole that shows onto it, and fixes it.
void set_poles(WorkSurface& surface, const SpecialBody& body);

}  // namespace ripstop
