#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Lays the curves of a model, other than grain lines (`is_grain_line`), onto the tiles they run over: load tapes,
/// artwork, marks. A curve that crosses seams is cut at them, to a hundredth of a millimetre; a run along an edge of
/// its tile is left out, for that is the seam itself. A point lies on the nearest tile if that is within 10 mm; tiles
/// narrower than a millimetre may be stepped over. `model` in metres.
///
/// Returns a sentence for each curve of which more than 5 mm lie on no tile, and one for those that lie on none at all.
/// O(points x #F) for the tiles whose box holds the points.
std::vector<std::string> lay_lines(const CadModel& model, Envelope& envelope,
                                   const std::vector<std::string>& grain_layers = {});

}  // namespace ripstop
