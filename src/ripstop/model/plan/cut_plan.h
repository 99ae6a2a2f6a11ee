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

/// A tile with its flattening and everything computed for it.
struct FlatTile {
    Tile tile;
    std::string method;
    Flattening flattening;
    Bounds bounds;  ///< known before the solve
    Accuracy accuracy;
    Verdict verdict;
    double seconds = 0;  ///< wall-clock time of this tile's solve; its share if all tiles are solved together; NaN if
                         ///< unknown
    int equal_to = -1;   ///< index in `CutPlan::tiles` of an earlier tile with the same pattern; -1: the first of its
                         ///< kind
    bool mirrored = false;                       ///< cut by that pattern turned over
    std::optional<SplitProposal> proposal = {};  ///< for a tile that cannot be manufactured

    /// True if every vertex has a finite flat position: false after a failed flattening.
    bool is_flat() const;
};

/// The result of `flatten`: every tile flattened and judged.
struct CutPlan {
    std::string input_file;
    std::string input_sha256;
    std::string unit = "m";                  ///< unit of the input file
    std::vector<std::string> remarks = {};   ///< parts of the input that were ignored or interpreted
    std::vector<std::string> warnings = {};  ///< sentences on what may be intended and is no finding
    Fabric fabric;                           ///< fabric of the tiles that name none
    Tolerances tolerances;
    std::vector<FlatTile> tiles;
    std::vector<Seam> seams = {};
    std::vector<SeamWalk> walks = {};    ///< one per seam; empty until they are walked
    std::vector<Finding> findings = {};  ///< faults between tiles; values and limits in mm
    std::vector<MergeProposal> merges = {};
    std::vector<double> tape_factors =
        {};  ///< ratio of the cut to the drawn length of each seam's load tape; empty: 1 everywhere
    bool is_compensated = false;  ///< cut for the strain in flight (`Compensation::strain`), which may not be available
    std::vector<CompensationRound> rounds = {};  ///< rounds of pattern compensation (`compensate`); empty if there were
                                                 ///< none
    std::optional<Flight> flight = {};           ///< flight conditions, if given
    std::optional<Inflated> inflated = {};       ///< present after the inflation

    bool manufacturable() const;  ///< every tile is manufacturable and there is no fault between them
    double area() const;          ///< total area of the tiles in space [m2]

    /// The tile's own fabric, otherwise the plan's; the plan's tolerances with the limits of that fabric.
    const Fabric& fabric_of(const Tile& tile) const { return tile.fabric_or(fabric); }
    Tolerances tolerances_of(const Tile& tile) const;
    /// Every fabric in use, each once, in the order of the tiles; the plan's own if there is no tile.
    std::vector<Fabric> fabrics() const;
};

/// How many pieces each tile's pattern cuts (`equal_to`), as drawn and turned over; none for a tile that equals an
/// earlier one.
struct Quantity {
    int same = 0, mirrored = 0;
};
std::vector<Quantity> quantities(const CutPlan& plan);

}  // namespace ripstop
