#pragma once

#include <vector>

#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {

/// The runs where three or more sheets meet on an edge, and what follows from them.
struct SheetOrder {
    std::vector<Run> beside;     ///< the runs of either direction that are long enough for a sheet's edge on another
    std::vector<bool> competes;  ///< for each run of equal direction
    std::vector<bool> shows_turned;  ///< for each of them that competes: whether it shows that a tile is turned over
};

/// Decides which of several sheets on an edge are the skin, whose run is the seam. Sets `turn` and `rank` of the
/// runs.
///
/// Two runs compete if, along one chain, more than half of the shorter one lies on both. Among competing runs, the
/// lowest rank is the skin's:
///
///     rank = sum over the two tiles of (20 if the project file names it as a diaphragm, less 3 if it is skin)
///          + cos(angle between the two sheets)
///
/// A tile is skin to the degree that one side sees the open and the other does not (`one_sidedness`: not at all up
/// to 0.5, fully from 0.75; a rib that leans towards its skin in the open hides up to half of what one side sees).
/// The angle lies between the directions from the edge into the two sheets, averaged along the run: the cosine is
/// -1 for straight on and 1 for folded flat. Equal ranks are decided by length, then by the tiles' names. The
/// order of the tiles does not matter. Nor does it matter which side of a further sheet is called its outside: the
/// sheet runs opposite to one of the skin's two sides, and its mate is chosen after the skin's seam.
///
/// A competing run of equal direction shows a tile that is turned over only if three sheets meet and its rank is
/// lower by 0.3 than that of every other run. A rib always runs in the direction of one of the skin's sides,
/// whichever of its sides is up; and where two skins cross, the sheets that go straight on do not belong to one
/// skin.
///
/// O(#runs), plus, for each chain, the square of the number of runs along it.
SheetOrder order_sheets(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                        std::vector<Run>& opposed, const std::vector<Run>& same_way, double tolerance);

/// True if a run is long enough for a sheet's edge on another: four tolerances and a quarter of the shorter chain.
bool is_long_run(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

}  // namespace ripstop
