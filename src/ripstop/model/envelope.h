#pragma once

#include <string>
#include <vector>

#include "ripstop/model/seam.h"
#include "ripstop/model/tile.h"

namespace ripstop {

/// The whole skin: its tiles in the order of the input, and where they are sewn together.
struct Envelope {
    std::vector<Tile> tiles;
    std::vector<Seam> seams = {};
};

/// A named surface before it is known to be a tile: what a file or a generator gives.
struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
    std::optional<Points2> drawn;  ///< flat positions from the file's texture coordinates, where each vertex has one
};

}  // namespace ripstop
