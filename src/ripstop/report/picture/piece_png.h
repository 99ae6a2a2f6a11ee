#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// What pictures of pieces are made from. `pieces`: of each tile its piece, or none. `maps`: all of `map_views`.
struct PieceSource {
    const CutPlan& plan;
    const std::vector<const PatternPiece*>& pieces;
    const std::vector<MapView>& maps;
};

/// The map that shows what is wrong with a tile first of all: strain along warp or weft, shear, area, edge error; the
/// strain along the warp where nothing is, or what is wrong has no map. The edge error where there are no strains.
const MapView& telling_map(const PieceSource& source, std::size_t tile);

/// A PNG picture, 1000 wide, of the piece of a tile as report.html shows it: name, verdict, what is wrong, figures; the
/// piece as cut in the colours of `telling_map`; its legend; scale bar; the sewn edges with their lengths and their
/// mates'.
std::string tile_png(const PieceSource& source, std::size_t tile);

/// A PNG picture, 1200 wide, of a seam as report.html shows it: verdict, lengths as drawn and on both pieces, mismatch;
/// how far the sides are apart along it, against what is allowed; both pieces with the seam green, a ring where it
/// starts.
std::string seam_png(const PieceSource& source, std::size_t seam);

}  // namespace ripstop
