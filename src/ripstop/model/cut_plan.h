#pragma once

#include <string>
#include <vector>

#include "ripstop/model/accuracy.h"
#include "ripstop/model/bounds.h"
#include "ripstop/model/envelope.h"
#include "ripstop/model/fabric.h"
#include "ripstop/model/flattening.h"
#include "ripstop/model/verdict.h"

namespace ripstop {

/// A tile with all that became of it.
struct FlatTile {
    Tile tile;
    std::string method;
    Flattening flattening;
    Bounds bounds;  ///< known before the solve
    Accuracy accuracy;
    Verdict verdict;
    double seconds = 0;  ///< of this tile's solve, wall clock; its share where all tiles are solved together
};

/// What `flatten` gives: every tile flattened and judged.
struct CutPlan {
    std::string input_file;
    std::string input_sha256;
    std::string unit = "m";  ///< of the input file
    Fabric fabric;
    Tolerances tolerances;
    std::vector<FlatTile> tiles;

    bool manufacturable() const;
    double area() const;  ///< of the tiles in space [m2]
};

}  // namespace ripstop
