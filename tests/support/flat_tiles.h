#pragma once

#include <string>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"

/// Tiles with known flat positions, for the steps after flattening.
namespace ripstop::testing {

/// The tile of `mesh` with these flat positions. The accuracy's lengths, areas and chains are measured; the
/// verdict has no findings.
FlatTile flat_tile(const std::string& name, const TriangleMesh& mesh, const Points2& positions);

/// A sheet bent to a prism and laid flat again: no errors.
FlatTile flat_cylinder(const std::string& name);

/// A gore of the unit sphere by the sinusoidal map: its area is exact, its seams are too long.
FlatTile sinusoidal_gore(const std::string& name);

/// A flat polygon (corners in order, seen from outside) as a tile of one fan or strip, with itself as flat shape.
FlatTile flat_polygon(const std::string& name, const Points2& corners);

/// The piece of a tile alone, with hems on all edges.
PatternPiece piece_of(const FlatTile& tile);

/// The two tiles above, called `G01 P01` and `Bílý "dráček"`, with a finding on the gore.
CutPlan two_tile_plan();

}  // namespace ripstop::testing
