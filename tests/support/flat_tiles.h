#pragma once

#include <string>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

/// Tiles with a known place on the cloth, for what comes after flattening.
namespace ripstop::testing {

/// The tile of `mesh` with the given flat positions; lengths, areas and chains of the accuracy measured, judged without
/// findings.
FlatTile flat_tile(const std::string& name, const TriangleMesh& mesh, const Points2& positions);

/// A sheet bent to a prism and laid flat again: no error anywhere.
FlatTile flat_cylinder(const std::string& name);

/// A gore of the unit sphere by the sinusoidal map: its area is exact, its seams are too long.
FlatTile sinusoidal_gore(const std::string& name);

/// A flat polygon (corners in order, seen from the tile's outside) as a tile of one fan or strip, flat as it is.
FlatTile flat_polygon(const std::string& name, const Points2& corners);

/// The piece of a tile alone, whose edges are all hems.
PatternPiece piece_of(const FlatTile& tile);

/// Both of the above with a finding on the gore, as `G01 P01` and `Bílý "dráček"`.
CutPlan two_tile_plan();

}  // namespace ripstop::testing
