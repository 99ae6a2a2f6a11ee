#pragma once

#include <string>

#include "ripstop/model/plan/cut_plan.h"

namespace ripstop {

/// The map from the cloth [m, y up] to the page [its units, y down].
struct PageView {
    double scale = 1;
    Vec2 origin = Vec2::Zero();  ///< place of the cloth's origin on the page

    Vec2 at(const Vec2& p) const { return {origin.x() + scale * p.x(), origin.y() - scale * p.y()}; }
};

/// The triangles of a flat tile as SVG, each in the colour (`class_colour`) of its `mean_edge_error` relative to
/// `limit`; flipped ones are black. There is at most one path per colour, so about 30 bytes per triangle. Requires
/// flat positions (`FlatTile::is_flat`).
std::string cloth_map(const FlatTile& tile, const PageView& view, double limit);

/// The mean of |edge length on the cloth / in space - 1| over the edges of a triangle.
double mean_edge_error(const FlatTile& tile, int triangle);

}  // namespace ripstop
