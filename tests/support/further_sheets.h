#pragma once

#include <string>
#include <vector>

#include "ripstop/model/tile/cad_model.h"

/// Envelopes in which three or more sheets meet on an edge: ribs, fins, diaphragms.
namespace ripstop::testing {

/// LEFT and RIGHT, 0.5 m wide, meet on the x axis from 0 to 1 m and rise from it by `slope` [rad]. RIB hangs from
/// there, 0.4 m deep, and leans by `lean` [rad] towards RIGHT. `edges`: numbers of edges of LEFT, RIGHT and RIB
/// along the x axis.
std::vector<NamedMesh> rib_under_seam(double slope, double lean = 0, const std::vector<int>& edges = {4, 4, 4});

/// LEFT along the x axis from 0 to 2 m, R1 and R2 on its halves, RIB below it from `from` to `to`. Each has a
/// different division.
std::vector<NamedMesh> rib_under_junction(double from, double to);

/// LEFT and RIB along the x axis from 0 to 2 m, RIGHT on the first half of LEFT; beyond it, RIB is LEFT's mate.
/// Each has a different division, and neither LEFT nor RIB has a vertex where RIGHT ends.
std::vector<NamedMesh> rib_past_seam();

/// The closed unit ball: `sectors` tiles UP0, … from the equator to the pole, as many DOWN0, …, and the tile DISC
/// in the equatorial plane. Tiles have `columns` edges on the equator; the disk has `disc_columns` for each of
/// them. The disk has no corners.
std::vector<NamedMesh> ball_with_disc(int sectors, int columns, int disc_columns);

/// A tube along x, 6 m long and 1 m in radius, of PORT and STARBOARD, which meet at its top and bottom. At its top
/// stands a fin of one sheet, FIN, or of two, FIN-P and FIN-S, which meet 0.8 m above.
std::vector<NamedMesh> hull_with_fin(bool of_two_sheets);

/// A closed wing of `cells` cells of 0.3 m: panels U (above), L (below), N (nose), T (tail) of each cell, numbered
/// from 1, and ribs R0 to R`cells`. Cells are arched by `lobe` [m] above and below. `apart`: each tile has its own
/// numbers of edges.
std::vector<NamedMesh> wing_with_ribs(int cells, double lobe, bool apart);

/// Five sheets on the x axis: TOP-L and TOP-R, BELOW-L and BELOW-R, and RIB, which belongs to neither pair.
std::vector<NamedMesh> two_skins_and_rib();

/// The tile with its other side up.
NamedMesh turned_over(NamedMesh mesh);

}  // namespace ripstop::testing
