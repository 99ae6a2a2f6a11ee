#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// Properties of a tile's mesh that affect its flattening.
struct MeshState {
    int triangles = 0;
    double area = 0;           ///< [m2]
    double mean_edge = 0;      ///< [m]
    double boundary_turn = 0;  ///< root mean square turn between edges of the worst chain [rad]
    double interior_turn = 0;  ///< area-weighted root mean square turn between triangles, without creases [rad]
    double turn_max = 0;       ///< the largest of both, without corners and creases [rad]
    double curvature = 0;      ///< curvature of the surface: sum of turn times edge length, over the area [1/m]
    double sliver_share = 0;   ///< fraction of triangles with an angle below 5 degrees
    double locked_share = 0;   ///< interior edges that join two boundary vertices, without those that cut off an ear,
                               ///< over boundary edges
    int chains = 0, boundary_edges = 0;

    bool is_flat() const;  ///< it turns by less than 0.01 rad in all, so every mesh of it is equally good
    /// The tile was cut along the edges of a mesh: it has more than six corners and fewer than three and a half edges
    /// per chain. Such a boundary follows no curve that could be resampled.
    bool is_jagged() const;
    /// A chain is shorter than its curve by more than half of this ratio. A polyline that turns by t at each edge is
    /// shorter by t^2 / 24.
    bool has_coarse_boundary(double length_tolerance) const;
};

/// Measures the mesh of a tile. O(#F).
MeshState measure_mesh(const Tile& tile);

/// The edge length of `triangles` equilateral triangles with this total area [m].
double edge_of(double area, double triangles);

/// Edges at which two triangles meet at more than `corner_turn`: they are intended and kept.
std::vector<std::array<int, 2>> find_creases(const TriangleMesh& mesh, const Adjacency& adjacency);

/// The edge length that accuracy requires [m]: 5 degrees over the curvature, limited so that the tile has at most
/// 4,000 and at least `fewest` triangles.
double needed_edge(const MeshState& state, double fewest = 1000);

/// A fault of a mesh.
struct MeshFault {
    enum Kind { too_fine, turns, slivers, locked };
    Kind kind = turns;
    double value = 0;  ///< number of triangles, largest turn [rad], fraction of slivers or fraction of locked edges

    std::string text() const;  ///< `edges turn by up to 14 degrees`
};

/// Why a tile is remeshed automatically; empty if its mesh is adequate. `length_tolerance`: of a seam, a ratio.
///
/// - *turns*, boundary: a polyline that turns by t per edge is short by t^2 / 24. More than half the tolerance (6.3
///   degrees at 0.1 %) is too coarse. Applies below 4,000 triangles only.
/// - *turns*, interior: an inscribed triangle with edges that turn by t lacks t^2 / 8 of its area, and its neighbour
///   turns from it by t / sqrt(3). More than a quarter of a per cent of area is 4.7 degrees. Applies only if the
///   edges are longer than `needed_edge`: remeshing does not improve cloth that is crumpled triangle by triangle.
/// - *slivers*: more than a tenth of the triangles have an angle below 5 degrees. Their shapes carry rounding and
///   noise into the energy.
/// - *locked*: interior edges that join two boundary vertices number more than a quarter of the boundary edges. They
///   keep the length of a straight line across the tile, which cloth does not do.
/// - *too fine*: more than 50,000 triangles whose edges are below a quarter of `needed_edge`. Drawings, pictures and
///   memory benefit; the flattening takes seconds either way.
///
/// A flat tile can only be too fine. `fewest`: see `needed_edge`.
std::optional<MeshFault> find_fault(const MeshState& state, double length_tolerance, double fewest = 1000);

}  // namespace ripstop
