#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/envelope.h"

/// Envelopes with known seams.
namespace ripstop::testing {

/// The seams of tiles whose meshes share vertices: boundary edges, of two tiles or of one, with the same ends in
/// space. A run of them along one chain on each side is a seam, measured on its chords.
std::vector<Seam> conforming_seams(const std::vector<Tile>& tiles);

/// The tiles with those seams.
Envelope sewn(std::vector<Tile> tiles);

/// The unit sphere made of `count` gores with these angles [rad], repeated around it. `columns` and `rows` are the
/// numbers of edges across the first one and along each. The warp runs from pole to pole.
Envelope gores(const std::vector<double>& angles, int count, int columns, int rows);

std::string numbered(char letter, std::size_t number);  ///< `G12`

/// The boundary edges of a chain, in order.
std::vector<int> edges_of_chain(const Tile& tile, int chain);

/// The largest relative difference between the flat lengths of the two sides of a seam. If a seam ends within an
/// edge, that edge's flat length is divided like its length.
double worst_mismatch(const Envelope& envelope, const std::vector<Points2>& flats);
/// The same from the seam's start to each vertex of either side; the other side is interpolated.
double worst_drift(const Envelope& envelope, const std::vector<Points2>& flats);

}  // namespace ripstop::testing
