#pragma once

#include "ripstop/design/special/special_surface.h"

namespace ripstop {

/// Cuts the surface along every crease and assigns each triangle to a face of the body. New vertices lie on the body
/// and on their curves; no triangle lies on both sides of one. Triangles may become arbitrarily thin, or flipped
/// where the first surface was far from the crease. Requires that all vertices lie on the body.
void cut_creases(WorkSurface& surface, const SpecialBody& body);

/// The same along sector seams, ring seams and the mouth: assigns each triangle to a cell. Requires `cut_creases` and
/// a vertex at each pole (`set_poles`).
void cut_seams(WorkSurface& surface, const SpecialBody& body);

/// Moves the vertex nearest to each visible pole onto it and fixes it.
void set_poles(WorkSurface& surface, const SpecialBody& body);

}  // namespace ripstop
