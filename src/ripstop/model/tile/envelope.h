#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/seam.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The whole balloon skin: its tiles in input order and their seams.
struct Envelope {
    std::vector<Tile> tiles;
    std::vector<Seam> seams = {};
};

}  // namespace ripstop
