#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// The data for pictures of pieces. `pieces`: for each tile its piece, or null. `maps`: all of `map_views`.
struct PieceSource {
    const CutPlan& plan;
    const std::vector<const PatternPiece*>& pieces;
    const std::vector<MapView>& maps;
};

/// The map that best shows a tile's worst fault: strain along warp or weft, shear, area, edge error. Without a fault,
/// or if the fault has no map, the strain along the warp; without strains, the edge error.
const MapView& telling_map(const PieceSource& source, std::size_t tile);

/// A PNG picture, 1000 pixels wide, of a tile's piece as in report.html: name, verdict, faults, figures; the piece as
/// cut, coloured by `telling_map`, with legend and scale bar; the sewn edges with their lengths and those of their
/// mates.
std::string tile_png(const PieceSource& source, std::size_t tile);

/// A PNG picture, 1200 pixels wide, of a seam as in report.html: verdict, mismatch, and lengths as drawn and on both
/// pieces; the distance between the sides along the seam, with its limit; both pieces with the seam in green and a ring
/// at its start.
std::string seam_png(const PieceSource& source, std::size_t seam);

}  // namespace ripstop
