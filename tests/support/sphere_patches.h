#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/envelope.h"

/// Tiles of the unit sphere between circles of latitude and longitude, each meshed independently.
namespace ripstop::testing {

/// A part of the sphere: longitudes and latitudes [rad], numbers of edges east and north.
struct Patch {
    std::string name;
    double west, east, south, north;
    int columns, rows;
};

/// The tiles of the patches, with edges measured on the sphere (`Tile::curve_lengths`), and the seams between all
/// that share a part of a circle. Patches may end within an edge of their neighbour.
Envelope sewn_patches(const std::vector<Patch>& patches);

}  // namespace ripstop::testing
