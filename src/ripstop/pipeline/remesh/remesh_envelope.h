#pragma once

#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// Which tiles are remeshed: none, those whose meshes have a fault, or all at one edge length.
enum class RemeshMode { never, automatic, by_length };

/// Which tiles `remesh_envelope` meshes anew, and how finely.
struct RemeshOptions {
    RemeshMode mode = RemeshMode::never;
    double edge_length = 0;                    ///< by length: of every tile's edges [m], > 0
    double length_tolerance = 0.1 * percent;   ///< of a seam: what its polyline may be short by is half of it
    double seam_tolerance = 0.5 * millimetre;  ///< as in `find_seams` [m]
    int threads = 0;                           ///< 0: one a core
};

/// Remeshes tiles of an envelope: where `automatic`, those with a fault (`find_fault`), at the edge length that
/// accuracy needs (`needed_edge`); `by_length`, all of them. The others keep their meshes, bit by bit.
///
/// Boundaries are divided for both sides of a seam at once (`divide_boundaries`), and the seams searched for again
/// between the new ones; where they are not the same, the tiles concerned stay as they were, before anything is meshed.
/// Then the tiles are meshed within their boundaries (`remesh_tile`; of equal tiles the first, the others take its
/// mesh, moved); where a mesh does not come out the tile stays as it was. So does, where `automatic`, a tile that was
/// cut along the edges of a mesh (`MeshState::is_jagged`). `Envelope::seams` and `Tile::curve_lengths` are those of the
/// seams as they were, over the new edges; `Tile::remeshed` says what became of a tile.
///
/// Returns remarks, one for each reason and edge length:
/// `214 tiles remeshed at 120 mm: edges turn by up to 14 degrees; 0.8 % more area than as drawn, up to 3 mm from it`;
/// and for tiles that would need it and stay as they were. Throws InputError for a length that is not above 0, one that
/// gives more than five million triangles, and `by_length` where the program was built without CGAL. About 0.2 s for
/// 1,000 new triangles.
std::vector<std::string> remesh_envelope(Envelope& envelope, const RemeshOptions& options);

}  // namespace ripstop
