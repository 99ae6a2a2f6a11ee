#pragma once

#include <string>
#include <vector>

#include "ripstop/model/piece/pattern_piece.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/model/plan/strain_map.h"

namespace ripstop {

/// The data that report.html draws beyond report.json, as bytes: `RSP1`; the length of a JSON text (4 bytes,
/// little-endian); that text; spaces up to a multiple of 4; the arrays that the text refers to by number (`arrays`:
/// start and length of each, from the end of the padding). Tiles, seams and pieces are in the order of report.json.
///
///     palettes[]  id, name, colours: `rrggbb` of each place (`page_places`)
///     maps[]   those of `map_views`: id, name, negative, positive, unsigned, in_flight, of_edges, states (names of
///              the values) and scales (`MapScale`; cloth: one number, or one per tile)
///     first    map, tile: shown first; is_y_up: which axis of the input is up
///     tiles[]  space, flat   {array, lower_m, step_m}: vertices as 16-bit steps from one to the next, on a grid
///              triangles     16-bit steps, 32-bit from 65536 vertices on
///              loop          the boundary's vertices, likewise; chains: where in it each chain starts
///              maps          for each map of the cloth {array, step}: a number per triangle, -32768 for flipped ones
///              edges         likewise for each map of the edges: a number per boundary edge, -32768 if unknown
///              rings         [vertex, finding] of `finding_marks`; proposed: the line of `proposed_ends`
///              strain_limit, shear_limit [rad]   limits of the tile's fabric
///              flight        for an inflated plan: space as above
///     seams[]  a, b          {tile, first, count, from, to}: a run of boundary edges; fractions of the first and the
///                            last one
///     pieces[] tile, cut, sew, slits, grain, lines, labels: points in 32-bit steps of 0.01 mm
///
/// Positions are accurate to 1/65536 of the tile's size; values to a thousandth of the end of the map's scale or
/// 1/32767 of the largest value. Equal arrays are stored once. Tiles without flat positions have no `flat` and no maps
/// of the piece. `strains`: one per tile, or empty.
std::string page_shapes(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains);

}  // namespace ripstop
