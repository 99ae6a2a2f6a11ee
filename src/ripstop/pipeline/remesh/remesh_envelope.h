#pragma once

#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Which tiles are remeshed: none, those whose meshes have a fault, or all with one edge length.
enum class RemeshMode { never, automatic, by_length };

/// Which tiles `remesh_envelope` remeshes, and how finely.
struct RemeshOptions {
    RemeshMode mode = RemeshMode::never;
    double edge_length = 0;                    ///< for `by_length`: the edge length of every tile [m], > 0
    double length_tolerance = 0.1 * percent;   ///< of a seam; its polyline may be short by half of it
    double seam_tolerance = 0.5 * millimetre;  ///< as in `find_seams` [m]
    int threads = 0;                           ///< 0: one per core
};

/// Remeshes tiles of an envelope. With `automatic`, these are the tiles with a fault (`find_fault`), at the edge length
/// that accuracy needs (`needed_edge`); with `by_length`, all tiles. The others keep their meshes bit by bit.
///
/// The boundaries on both sides of a seam are divided together (`divide_boundaries`), and the seams between the new
/// boundaries are searched again. If these differ, the tiles concerned are unchanged; this is known before anything is
/// meshed. Then the tiles are meshed within their boundaries (`remesh_tile`); of equal tiles only the first is meshed,
/// and the others get a moved copy. A tile whose mesh fails is unchanged. So is, with `automatic`, a tile that was cut
/// along the edges of a mesh (`MeshState::is_jagged`). `Envelope::seams` and `Tile::curve_lengths` keep the lengths of
/// the old seams on the new edges. `Tile::remeshed` records the result for each tile.
///
/// Returns remarks, one for each reason and edge length: `214 tiles remeshed at 120 mm: edges turn by up to 14 degrees;
/// 0.8 % more area than as drawn, up to 3 mm from it`; and one for tiles that would need remeshing but are unchanged.
/// Throws InputError for a length that is not above 0, for a length that gives more than five million triangles, and
/// for `by_length` in a program built without CGAL. About 0.2 s per 1,000 new triangles.
std::vector<std::string> remesh_envelope(Envelope& envelope, const RemeshOptions& options);

}  // namespace ripstop
