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
    const PatternPiece* piece = nullptr;  ///< null: only the flat tile
    const MapView& map;
    bool has_band = true;  ///< along the edges, if the map covers edges
    int seam = -1;         ///< index in `CutPlan::seams`: drawn green, without rings for findings
    double scale = 0;      ///< page units per metre; 0: `fitting_scale`
};

/// Lower left and upper right corner of the cut line and the cloth together [m].
struct PieceExtent {
    Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();
    Vec2 size() const { return upper - lower; }
};
PieceExtent piece_extent(const FlatTile& tile, const PatternPiece* piece);

/// The scale [page units per metre] at which a piece of this size [m] fits into `room`, with a margin for rings.
double fitting_scale(const Vec2& size, const Vec2& room);

/// A piece as in report.html (apps/report/src/piece/piece_view.js), centred between two corners of the page (upper
/// left, lower right). The triangles are pixels in the colours of the map. Drawn over them as SVG: cut line (solid),
/// sew line (dashed), notches, lines, grain, readable labels, a proposed seam (dashed) and a ring around each finding.
///
/// Without flat positions there are no pixels, and the SVG says so. O(triangles + pixels).
struct PieceView {
    std::string svg;
    std::vector<PlacedPixels> pixels;
    PageView to_page;  ///< from the cloth
};
PieceView piece_view(const PieceSight& sight, const Vec2& upper_left, const Vec2& lower_right);

}  // namespace ripstop
