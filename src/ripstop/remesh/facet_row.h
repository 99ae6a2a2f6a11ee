#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/smooth_surface.h"

namespace ripstop {

/// The smooth surface of a tile whose facets lie in a row, each bent from the next along one straight crease that runs
/// from boundary to boundary: straps, sleeves, cones, tangent developables, one quad across or many. Such a polyhedron
/// unrolls flat. Nothing is known of it across the row, so it is taken as ruled there: between two creases from side a
/// to side b
///
///     S(u, v) = (1 - v) a(u) + v b(u)
///
/// with a and b the cubics of the boundary on both sides (`BoundarySlopes`). The creases stay where they are and get
/// smooth; of a cylinder, a cone and a tangent developable it is true to the fourth order of the facets' turn, and it
/// bends one way only.
///
/// Side a runs along the boundary, side b against it, in the same cells: between two creases one, or as many as the
/// sides have edges there. A place on the row is `along` in [0, cells] and `across` in [0, 1], from a to b.
class FacetRow {
  public:
    /// Nothing where the facets do not lie in a row. Triangles are one facet where they meet at less than 0.2 degrees,
    /// or at less than half of what the sharpest other edge of the two does; a crease is straight within a thousandth
    /// of its length; an end of the row is straight, or a tip; creases that fan out from a corner of the tile do so to
    /// the end. `tile` must outlive it. O(#F log #F).
    static std::optional<FacetRow> find(const Tile& tile, const Adjacency& adjacency, const BoundarySlopes& slopes);

    Vec3 at(const MeshPlace& place) const;

    int cell_count() const { return static_cast<int>(cells_.size()); }
    Vec3 at(double along, double across) const;
    /// The same on the polyhedron: bilinear between the edges of both sides.
    Vec3 faceted_at(double along, double across) const;
    /// Where a place of the boundary is along side a, along side b; nothing where it is not on that side.
    std::optional<double> along_a(const BoundaryPlace& place) const;
    std::optional<double> along_b(const BoundaryPlace& place) const;
    /// Where side a begins and ends, side b ends and begins: indices into the boundary. At a tip two are the same.
    const std::array<int, 4>& corners() const { return corners_; }
    /// The triangle of the polyhedron whose middle is nearest to a point, of those about this place along the row.
    int triangle_near(double along, const Vec3& point) const;

  private:
    /// A stretch of a boundary edge; both ends the same where a side has none between two creases.
    struct Side {
        int edge = 0;
        double from = 0, to = 0;
    };
    struct Cell {
        Side a, b;
    };
    struct Foot {
        double u = 0, v = 0, off = 0;
    };
    friend class RowFinder;

    Vec3 chord_at(const Side& side, double u) const;
    Vec3 curve_at(const Side& side, double u) const;
    Foot foot_in(const Cell& cell, const Vec3& point) const;
    std::optional<double> along(const BoundaryPlace& place, Side Cell::*side) const;

    const Tile* tile_ = nullptr;
    BoundarySlopes slopes_;
    std::vector<int> facet_;       ///< of each triangle, in the order of the row
    std::vector<Cell> cells_;      ///< in the order of the row
    std::vector<int> first_cell_;  ///< of each facet, and one more
    std::array<int, 4> corners_{};
};

}  // namespace ripstop
