#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// What the colours of a picture are scaled to.
struct PictureOptions {
    /// What the colours of the cloth are pinned to, as a ratio; 0: the strain tolerance, which is what the cloth
    /// between the seams is judged by. The length tolerance gives the paper's pictures.
    double cloth_limit = 0;
};

/// An SVG picture of the flat tile in the paper's colours, for people: name, verdict and figures; each triangle in the
/// colour of the mean |edge length on the cloth / in space - 1| of its edges; each chain drawn over it in the colour of
/// its own length error against the length tolerance, its error in % written beside; a ring where a finding lies; the
/// warp, a scale bar and both colour scales with their numbers. 960 units wide. Flipped triangles are black.
///
/// At most one path a colour, so about 30 bytes a triangle. A tile without flat positions gets its name and why. The
/// seam chains of `accuracy` must be the tile's, in order; where there are none, the outline is grey.
std::string tile_picture(const FlatTile& tile, const Tolerances& tolerances, const PictureOptions& options = {});

}  // namespace ripstop
