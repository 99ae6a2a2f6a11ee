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
///     tiles[]  space, flat   {array, lower_m, step_m}: vertices as steps of 16 bits from one to the next, on a grid
///              triangles     steps of 16 bits, of 32 from 65536 vertices on
///              loop          the boundary's vertices, likewise; chains: where in it each chain starts
///              maps          warp, weft, shear [rad], area, edges: {array, step}, a number a triangle,
///                            -32768 for flipped ones
///              edge_error, tension [N]   the same, a number a boundary edge
///              strain_limit, shear_limit [rad]   what the tile's fabric stands
///              flight        of an inflated plan: space as above; deviation [m], a number a vertex; tension, the
///                            larger principal one, warp, weft, shear [N/m], strain_warp, strain_weft, strain_shear
///                            [rad] and state (`ClothState`), a number a triangle
///     seams[]  a, b          {tile, first, count, from, to}: a run of boundary edges; shares of the first and the
///                            last one
///     pieces[] tile, cut, sew, slits, grain, lines, labels: points in steps of 32 bits, 0.01 mm
///
/// Positions are right to 1/65536 of the tile's size, strains to 1e-5 or 1/32767 of the largest. Equal arrays are
/// stored once. Tiles without flat positions have no `flat` and no maps. `strains`: one a tile, or none at all.
std::string page_shapes(const CutPlan& plan, const std::vector<PatternPiece>& pieces,
                        const std::vector<StrainMap>& strains);

}  // namespace ripstop
