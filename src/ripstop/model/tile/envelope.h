#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/seam.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The whole skin: its tiles in the order of the input, and where they are sewn together.
struct Envelope {
    std::vector<Tile> tiles;
    std::vector<Seam> seams = {};
};

}  // namespace ripstop
