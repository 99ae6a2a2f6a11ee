#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Lays the curves of a model, except grain lines (`is_grain_line`), onto the tiles below them: load tapes, artwork,
/// marks. A curve that crosses seams is split there, to a hundredth of a millimetre. A run along an edge of its tile is
/// left out, because it is the seam itself. A point lies on the nearest tile within 10 mm; tiles narrower than a
/// millimetre may be skipped. `model` in metres.
///
/// Returns one sentence for each curve with more than 5 mm off all tiles, and one for the curves that lie on no tile.
/// O(points x #F) for the tiles whose box holds the points.
std::vector<std::string> lay_lines(const CadModel& model, Envelope& envelope,
                                   const std::vector<std::string>& grain_layers = {});

}  // namespace ripstop
