#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// What report.html draws and report.json does not hold, as bytes: `RSP1`, the length of a JSON text (4 bytes,
/// little-endian), that text, spaces up to a multiple of 4, then the arrays it points at by number (`arrays`: start and
/// length of each in what follows the text). Tiles, seams and pieces stand as in report.json.
///
///     palettes[]  id, name, colours: `rrggbb` of each place (`page_places`)
///     maps[]   those of `map_views`: id, name, negative, positive, unsigned, in_flight, of_edges, states (names of
///              the values) and scales (`MapScale`; cloth: one number, or one a tile)
///     first    map, tile: what is shown first; is_y_up: which axis of the input is up
///     tiles[]  space, flat   {array, lower_m, step_m}: vertices as steps of 16 bits from one to the next, on a grid
///              triangles     steps of 16 bits, of 32 from 65536 vertices on
///              loop          the boundary's vertices, likewise; chains: where in it each chain starts
///              maps          of each map of the cloth {array, step}: a number a triangle, -32768 for flipped ones
///              edges         of each map of the edges the same: a number a boundary edge, -32768 where nothing
///                            is known
///              rings         [vertex, finding] of `finding_marks`; proposed: the line of `proposed_ends`
///              strain_limit, shear_limit [rad]   what the tile's fabric stands
///              flight        of an inflated plan: space as above
///     seams[]  a, b          {tile, first, count, from, to}: a run of boundary edges; shares of the first and the
///                            last one
///     pieces[] tile, cut, sew, slits, grain, lines, labels: points in steps of 32 bits, 0.01 mm
///
/// Positions are right to 1/65536 of the tile's size, values to a thousandth of where the map's scale ends or 1/32767
/// of the largest. Equal arrays are stored once. Tiles without flat positions have no `flat` and no maps of the piece.
/// `strains`: one a tile, or none at all.
std::string page_shapes(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains);

}  // namespace ripstop
