#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/remesh/smooth_surface.h"

namespace ripstop {

/// The smooth surface of a tile whose facets form a row, separated by straight creases from boundary to boundary:
/// straps, sleeves, cones, tangent developables, one quad across or many. Such a polyhedron unrolls flat. The mesh
/// has no information across the row, so the surface is ruled there: between two creases, from side a to side b,
///
///     S(u, v) = (1 - v) a(u) + v b(u)
///
/// where a and b are the cubics of the boundary on both sides (`BoundarySlopes`). The creases keep their place and
/// become smooth. The surface reproduces cylinders, cones and tangent developables to fourth order in the facets'
/// turn, and bends in one direction only.
///
/// Side a runs along the boundary, side b against it, divided into the same cells: one between two creases, or as
/// many as the sides have edges there. A place on the row is `along` in [0, cells] and `across` in [0, 1], from a to
/// b.
class FacetRow {
  public:
    /// Finds the row; empty if the facets do not form one. Triangles belong to one facet if they meet at less than
    /// 0.2 degrees, or at less than half the turn of the sharpest other edge of the two. A crease is straight within
    /// a thousandth of its length. An end of the row is straight or a tip; creases that fan out from a corner of the
    /// tile do so to the end. `tile` must outlive the result. O(#F log #F).
    static std::optional<FacetRow> find(const Tile& tile, const Adjacency& adjacency, const BoundarySlopes& slopes);

    Vec3 at(const MeshPlace& place) const;

    int cell_count() const { return static_cast<int>(cells_.size()); }
    Vec3 at(double along, double across) const;
    /// The same on the polyhedron: bilinear between the edges of both sides.
    Vec3 faceted_at(double along, double across) const;
    /// The parameter of a boundary place along side a, or along side b; empty if it is not on that side.
    std::optional<double> along_a(const BoundaryPlace& place) const;
    std::optional<double> along_b(const BoundaryPlace& place) const;
    /// The start and end of side a, then the end and start of side b, as indices into the boundary. At a tip two are
    /// equal.
    const std::array<int, 4>& corners() const { return corners_; }
    /// The triangle of the polyhedron whose centroid is nearest to a point, among those near this place along the
    /// row.
    int triangle_near(double along, const Vec3& point) const;

  private:
    /// A part of a boundary edge; both ends are equal if a side has no edge between two creases.
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
    std::vector<int> facet_;       ///< facet of each triangle, numbered along the row
    std::vector<Cell> cells_;      ///< in order along the row
    std::vector<int> first_cell_;  ///< first cell of each facet, and the number of cells at the end
    std::array<int, 4> corners_{};
};

}  // namespace ripstop
