#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/envelope.h"

/// Envelopes whose seams are known.
namespace ripstop::testing {

/// The seams of tiles whose meshes share vertices: boundary edges of two tiles, or of one, with the same two ends in space.
/// A run of them along one chain on each side is a seam, measured on its chords.
std::vector<Seam> conforming_seams(const std::vector<Tile>& tiles);

/// The tiles with those seams.
Envelope sewn(std::vector<Tile> tiles);

/// The unit sphere of gores, of these angles [rad] again and again around it: `count` in all. `columns`, `rows`: edges across
/// the first one and along each. The warp runs from pole to pole.
Envelope gores(const std::vector<double>& angles, int count, int columns, int rows);

std::string numbered(char letter, std::size_t number);  ///< `G12`

/// The boundary edges of a chain, in its order.
std::vector<int> edges_of_chain(const Tile& tile, int chain);

/// Largest difference between the flat lengths of the two sides of a seam, over its length. Where a seam ends within an edge,
/// its flat length is shared as its length is.
double worst_mismatch(const Envelope& envelope, const std::vector<Points2>& flats);
/// The same from its start to each vertex of either side, where the other lies between two vertices interpolated.
double worst_drift(const Envelope& envelope, const std::vector<Points2>& flats);

}  // namespace ripstop::testing
