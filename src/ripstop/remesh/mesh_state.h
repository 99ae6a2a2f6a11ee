#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// What the flattening of a tile asks of its mesh, and has not got.
struct MeshState {
    int triangles = 0;
    double area = 0;           ///< [m2]
    double mean_edge = 0;      ///< [m]
    double boundary_turn = 0;  ///< from edge to edge of a chain, root mean square; of the worst chain [rad]
    double interior_turn = 0;  ///< from triangle to triangle, root mean square over the area; creases left out [rad]
    double turn_max = 0;       ///< the largest of either kind, corners and creases left out [rad]
    double curvature = 0;      ///< of the surface: turn times edge length summed, over the area [1/m]
    double sliver_share = 0;   ///< triangles with an angle below 5 degrees, of all
    double locked_share = 0;   ///< interior edges that join two boundary vertices, no ear cut off, over boundary edges
    int chains = 0, boundary_edges = 0;

    bool is_flat() const;  ///< it turns by less than 0.01 rad in all: every mesh of it is as good
    /// It was cut along the edges of a mesh: more than six corners, and less than three and a half edges from one to
    /// the next. Such a boundary is no curve that could be divided anew.
    bool is_jagged() const;
    /// A chain is shorter than its curve by more than half of this ratio. A polyline that turns by t at each edge is
    /// shorter by t^2 / 24.
    bool has_coarse_boundary(double length_tolerance) const;
};

/// Measures the mesh of a tile. O(#F).
MeshState measure_mesh(const Tile& tile);

/// The edges of `triangles` equilateral triangles of this area together [m].
double edge_of(double area, double triangles);

/// Edges where two triangles meet at more than `corner_turn`: meant, and kept.
std::vector<std::array<int, 2>> find_creases(const TriangleMesh& mesh, const Adjacency& adjacency);

/// The edge length that accuracy asks for [m]: 5 degrees over the curvature, but no less than what gives 4,000
/// triangles and no more than what gives `fewest`.
double needed_edge(const MeshState& state, double fewest = 1000);

/// What is wrong with a mesh.
struct MeshFault {
    enum Kind { too_fine, turns, slivers, locked };
    Kind kind = turns;
    double value = 0;  ///< triangles, the largest turn [rad], the share of slivers, the share of locked edges

    std::string text() const;  ///< `edges turn by up to 14 degrees`
};

/// Why a tile is remeshed unasked; nothing where its mesh will do. `length_tolerance`: of a seam, a ratio.
///
/// - *turns*, boundary: a polyline that turns by t an edge is short by t^2 / 24; more than half of the tolerance (6.3
///   degrees at 0.1 %) is too coarse. Only below 4,000 triangles.
/// - *turns*, interior: an inscribed triangle with edges that turn by t lacks t^2 / 8 of its area, and its neighbour is
///   turned from it by t / sqrt(3); more than a quarter of a per cent of area is 4.7 degrees. Only where the edges are
///   longer than `needed_edge`: cloth that is crumpled triangle by triangle gets no better.
/// - *slivers*: more than a tenth of the triangles has an angle below 5 degrees. Their shapes carry rounding and noise
///   into the energy.
/// - *locked*: more than a quarter as many interior edges that join two boundary vertices as boundary edges. They keep
///   the length of a straight line across the tile, which no cloth does.
/// - *too fine*: more than 50,000 triangles whose edges are below a quarter of `needed_edge`: drawings, pictures and
///   memory gain; the flattening itself takes seconds either way.
///
/// A flat tile is only ever too fine. `fewest`: as `needed_edge` takes it.
std::optional<MeshFault> find_fault(const MeshState& state, double length_tolerance, double fewest = 1000);

}  // namespace ripstop
