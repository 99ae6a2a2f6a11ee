#pragma once

#include <vector>

#include "ripstop/design/natural/gores.h"
#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/envelope.h"

/// Envelopes whose seams are known.
namespace ripstop::testing {

/// The tiles of a design, each meshed by itself: its own numbers of rows and columns, and rows and columns spaced unevenly,
/// from the design's surface. Corners coincide and edges follow the same curves; between corners no vertices are shared.
/// `finer` multiplies the numbers.
std::vector<NamedMesh> meshed_apart(const EnvelopeDesign& design, unsigned seed, double finer = 1);

/// How many seams a design has whose mouth and crown are open: between gores and between panels.
int seam_count(const EnvelopeDesign& design);

/// A band of the unit sphere from latitude -`latitude` to `latitude` in `rows` rows of `bricks` tiles all round, every second
/// row shifted by half a tile: each long edge lies against two halves. Each row has its own number of edges.
std::vector<NamedMesh> brick_wall(int rows, int bricks, double latitude = 0.9);

/// A tube of four flat sides, 2 m wide and 3 m high, in three rows: tile T1-2 is of side 1, row 2.
std::vector<NamedMesh> square_tube();

/// The tiles as an envelope without seams.
Envelope tiles_of(const std::vector<NamedMesh>& meshes);

}  // namespace ripstop::testing
