#pragma once

#include <vector>

#include "ripstop/assembly/seams/seam_runs.h"

namespace ripstop {

/// What is known of the runs where three or more sheets meet on an edge.
struct SheetOrder {
    std::vector<Run> beside;     ///< the runs, whichever way, long enough to be a sheet's edge on another of its layer
    std::vector<bool> competes;  ///< of each run that runs the same way
    std::vector<bool> shows_turned;  ///< of each of them, where it competes: a tile is turned over
};

/// Decides who of several sheets on an edge are the skin, whose seam it is, and sets `turn` and `rank` of the runs.
///
/// Two runs compete where both lie on more than half of the shorter of them along one chain. Of those that do the
/// lowest rank is the skin's:
///
///     rank = sum over the two tiles of (20 if the project file names it as a diaphragm, less 3 if it is skin)
///          + cos(angle between the two sheets)
///
/// A tile is skin by as much as one side of it sees the open and the other does not (`one_sidedness`: not at all to
/// 0.5, wholly from 0.75; a rib that leans to its skin in the open hides up to half of what one side sees). The angle
/// is that from the edge into one sheet to that into the other, so that straight on is -1 and folded flat 1, the mean
/// along the run. Equal ranks go by length, then by the names of the tiles. Neither the order of the tiles nor the side
/// of a further sheet that is called its outside plays a part: that sheet runs against one of the skin's two, and its
/// mate is chosen after the skin's seam.
///
/// Of runs of the same way, one that competes is a sign of a tile turned over only where three sheets meet and its rank
/// is lower by 0.3 than that of every other: a rib runs the same way as one of the skin's sides, whichever side of it
/// is up, and where two skins cross, the sheets that go straight on are none of one skin.
///
/// O(#runs) and, of each chain, the square of the runs along it.
SheetOrder order_sheets(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                        std::vector<Run>& opposed, const std::vector<Run>& same_way, double tolerance);

/// Is a run as long as a sheet's edge on another: four tolerances and a quarter of the shorter chain?
bool is_long_run(const std::vector<PlacedChain>& chains, const Run& run, double tolerance);

}  // namespace ripstop
