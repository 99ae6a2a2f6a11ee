#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/model/flight/flight.h"
#include "ripstop/model/plan/accuracy.h"
#include "ripstop/model/plan/bounds.h"
#include "ripstop/model/plan/flattening.h"
#include "ripstop/model/plan/redesign.h"
#include "ripstop/model/plan/seam_walk.h"
#include "ripstop/model/plan/verdict.h"
#include "ripstop/model/tile/envelope.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// A tile with all that became of it.
struct FlatTile {
    Tile tile;
    std::string method;
    Flattening flattening;
    Bounds bounds;  ///< known before the solve
    Accuracy accuracy;
    Verdict verdict;
    double seconds = 0;     ///< of this tile's solve, wall clock; its share where all tiles are solved together
    int equal_to = -1;      ///< in `CutPlan::tiles`: an earlier tile that is cut alike; -1: the first of its kind
    bool mirrored = false;  ///< its pattern is that one's turned over
    std::optional<SplitProposal> proposal = {};  ///< for a tile that cannot be made
};

/// What `flatten` gives: every tile flattened and judged.
struct CutPlan {
    std::string input_file;
    std::string input_sha256;
    std::string unit = "m";                 ///< of the input file
    std::vector<std::string> remarks = {};  ///< what of the input was left out or taken otherwise than it stands
    Fabric fabric;                          ///< of the tiles without one of their own
    Tolerances tolerances;
    std::vector<FlatTile> tiles;
    std::vector<Seam> seams = {};
    std::vector<SeamWalk> walks = {};    ///< one a seam; none before they are walked
    std::vector<Finding> findings = {};  ///< what is wrong between the tiles; values and limits in mm
    std::vector<MergeProposal> merges = {};
    std::vector<double> tape_factors =
        {};  ///< of each seam: its load tape is cut so much longer than drawn; 1 where empty
    bool is_compensated =
        false;  ///< cut for the strain it has in flight (`Compensation::strain`), which may not be at hand
    std::optional<Flight> flight = {};      ///< how it is to fly, where that was said
    std::optional<Inflated> inflated = {};  ///< once it was sewn and inflated

    bool manufacturable() const;  ///< every tile, and nothing wrong between them
    double area() const;          ///< of the tiles in space [m2]

    /// The tile's own fabric, else the plan's; the plan's tolerances with the limits of that fabric.
    const Fabric& fabric_of(const Tile& tile) const { return tile.fabric_or(fabric); }
    Tolerances tolerances_of(const Tile& tile) const;
    /// Every fabric that is cut, each once, in the order of the tiles; the plan's own where there is no tile.
    std::vector<Fabric> fabrics() const;
};

/// How many pieces are cut by each tile's pattern (`equal_to`), and how many by the pattern turned over. None by one
/// that is equal to an earlier tile.
struct Quantity {
    int same = 0, mirrored = 0;
};
std::vector<Quantity> quantities(const CutPlan& plan);

}  // namespace ripstop
