#pragma once

#include <vector>

#include "ripstop/design/natural/gores.h"
#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/envelope.h"

/// Envelopes with known seams.
namespace ripstop::testing {

/// The tiles of a design, each meshed independently from the design's surface: with its own numbers of rows and
/// columns, unevenly spaced. Corners coincide and edges follow the same curves, but between corners no vertices
/// are shared. `finer` multiplies the numbers.
std::vector<NamedMesh> meshed_apart(const EnvelopeDesign& design, unsigned seed, double finer = 1);

/// The number of seams of a design with open mouth and crown: between gores and between panels.
int seam_count(const EnvelopeDesign& design);

/// A band of the unit sphere from latitude -`latitude` to `latitude`, of `rows` rows with `bricks` tiles each.
/// Every second row is shifted by half a tile, so each long edge meets two halves. Each row has its own number of
/// edges.
std::vector<NamedMesh> brick_wall(int rows, int bricks, double latitude = 0.9);

/// A tube with four flat sides, 2 m wide and 3 m high, in three rows: tile T1-2 is on side 1, row 2.
std::vector<NamedMesh> square_tube();

/// The tiles as an envelope without seams.
Envelope tiles_of(const std::vector<NamedMesh>& meshes);

}  // namespace ripstop::testing
