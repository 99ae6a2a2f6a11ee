#pragma once

#include <string>
#include <vector>

#include "ripstop/io/text/png.h"
#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/figures/cloth_map.h"
#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// What a view of a piece shows.
struct PieceSight {
    const CutPlan& plan;
    std::size_t tile = 0;
    const PatternPiece* piece = nullptr;  ///< none: the flat tile alone
    const MapView& map;
    bool has_band = true;  ///< along the edges, where the map is of them
    int seam = -1;         ///< in `CutPlan::seams`: drawn green; then no finding has a ring
    double scale = 0;      ///< units of the page a metre; 0: `fitting_scale`
};

/// Lower left and upper right of what is cut, and of the cloth [m].
struct PieceExtent {
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();
    Vec2 size() const { return upper - lower; }
};
PieceExtent piece_extent(const FlatTile& tile, const PatternPiece* piece);

/// Units of the page a metre at which a piece of this size [m] fits into a room of the page, with a margin for rings.
double fitting_scale(const Vec2& size, const Vec2& room);

/// A piece as report.html shows it (apps/report/src/piece/piece_view.js), in the middle between two corners of the page
/// (upper left, lower right): the triangles in the colours of the map as pixels, and over them, as SVG, cut line
/// (solid), sew line (dashed), notches, lines, grain, labels that can be read, a proposed seam (dashed) and a ring
/// about each finding.
///
/// Without flat positions there are no pixels, and the SVG says so. Cost: O(triangles + pixels).
struct PieceView {
    std::string svg;
    std::vector<PlacedPixels> pixels;
    PageView to_page;  ///< from the cloth
};
PieceView piece_view(const PieceSight& sight, const Vec2& upper_left, const Vec2& lower_right);

}  // namespace ripstop
