#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The scale of a picture's colours.
struct PictureOptions {
    /// The ratio at full colour. 0: the strain tolerance, by which the cloth between the seams is judged. The length
    /// tolerance reproduces the paper's pictures.
    double cloth_limit = 0;
};

/// An SVG picture of the flat tile in the paper's colours. It shows name, verdict and figures; each triangle, coloured
/// by the mean |edge length on the cloth / in space - 1| of its edges; each chain, coloured by its length error against
/// the length tolerance, with the error in % beside it; a ring at each finding; the warp, a scale bar and both colour
/// scales with numbers. It is 960 units wide. Flipped triangles are black.
///
/// At most one path per colour, so about 30 bytes per triangle. A tile without flat positions shows its name and the
/// reason. The seam chains of `accuracy` must be the tile's, in order; without any, the outline is grey.
std::string tile_picture(const FlatTile& tile, const Tolerances& tolerances, const PictureOptions& options = {});

}  // namespace ripstop
