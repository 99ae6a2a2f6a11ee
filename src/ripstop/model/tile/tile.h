#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/mesh/triangle_mesh.h"
#include "ripstop/model/tile/cad_model.h"
#include "ripstop/model/tile/fabric.h"
#include "ripstop/model/tile/remeshed.h"
#include "ripstop/model/tile/seam_type.h"

namespace ripstop {

/// A run of a tile's boundary from one corner to the next, corners included, counter-clockwise seen from outside. A
/// tile without corners has one chain that ends where it starts.
struct Chain {
    std::vector<int> vertices;
    SeamType finish = default_hem();  ///< of what of it is in no seam
    int edge_count() const { return static_cast<int>(vertices.size()) - 1; }
};

/// The warp of a tile: a direction in space, laid onto the surface by projection (`lay_on_cloth`). `source` says where
/// it comes from, for the report.
struct Grain {
    Vec3 direction = Vec3::UnitX();  ///< unit length
    std::string source;
    Points3 field = {};  ///< #F x 3: of each triangle its own, of unit length; empty: `direction` for all
};

/// How the cloth is to be cut otherwise than drawn. Ratios: 0.005 is half a per cent longer. What shrinks in use is cut
/// longer, what stretches shorter.
struct Compensation {
    double warp = 0, weft = 0;        ///< of the whole cloth, along its threads, each in (-0.5, 1)
    std::vector<double> chains = {};  ///< of the edges alone, beside warp and weft, chain by chain; missing ones 0
    /// #F x 3: Green strain E11, E22, 2 E12 (warp, weft) that each triangle is to have where it lies as drawn, before
    /// `warp` and `weft`: what it is stretched by in flight; empty: none. With it `edges` (#boundary): cloth a drawn
    /// length of each boundary edge, the same on both sides of a seam, before the others.
    Points3 strain = {};
    Eigen::VectorXd edges = {};

    bool any() const { return warp != 0 || weft != 0 || !chains.empty() || strain.rows() > 0; }
};

/// A line of the drawing that lies on a tile: a load tape, artwork, a mark.
struct SurfaceLine {
    std::string name;
    Points3 points;  ///< at least 2 x 3; on the surface, or as near to it as it was drawn [m]
};

/// A curved patch between seams: an oriented disk with its corners, chains and warp.
struct Tile {
    std::string name;
    TriangleMesh mesh;
    std::vector<int> boundary;  ///< the loop of boundary vertices, counter-clockwise seen from outside
    std::vector<Chain> chains;  ///< they cover the boundary once, in its order
    Grain grain;
    std::optional<Points2> drawn;  ///< #V x 2: flat positions that came with the input [m]
    Compensation compensation;
    Eigen::VectorXd curve_lengths;  ///< of each boundary edge on the curve its seam follows [m]; empty: the edge's own
    Attributes attributes = {};     ///< what the file says of it
    std::vector<SurfaceLine> lines = {};
    std::optional<Fabric> fabric = {};      ///< where it is not the envelope's
    std::optional<Remeshed> remeshed = {};  ///< where its mesh is not the input's
    bool inside = false;                    ///< a diaphragm by the project file: no part of the skin

    const Fabric& fabric_or(const Fabric& of_envelope) const { return fabric ? *fabric : of_envelope; }
};

/// How `make_tile` finds the corners and the warp of a tile.
struct TileOptions {
    double corner_angle = 30 * degree;  ///< a boundary vertex that turns by more is a corner [rad]
    std::vector<Vec3> corners = {};     ///< if any: these instead, each the boundary vertex nearest to the point
    std::optional<Vec3> warp = {};      ///< if none: the longest axis
    Points3 warp_field = {};            ///< #F x 3: of each triangle its own; used where no `warp` is given; else empty
    std::string warp_source = "given";  ///< where the warp comes from, in words
    std::optional<double> grain_turn = {};  ///< turns the longest axis, counter-clockwise seen from outside [rad]
    std::optional<Points2> drawn = {};
    Compensation compensation = {};
    Attributes attributes = {};
};

/// The tile of a mesh. Corners are where the boundary turns by more than `corner_angle` on the surface: pi less the sum
/// of the triangle angles at the vertex, so a gentle curve in space is no corner. Throws InputError (`require_disk`; a
/// warp that stands on the surface).
Tile make_tile(std::string name, TriangleMesh mesh, const TileOptions& options = {});

/// How much the boundary turns at each of its vertices, on the surface: pi less the angles there [rad]. Positive turns
/// left.
Eigen::VectorXd surface_turning(const TriangleMesh& mesh, const std::vector<int>& boundary);

/// The tile's longest direction: the axis of greatest second moment of its area, towards +z (else +y, else +x). Where
/// there are several such, as all round a tube, that of the unrolled tile (`longest_axis_on_cloth`).
Vec3 longest_axis(const TriangleMesh& mesh);

/// The warp in the frame of each triangle (2 x #F): its part along the triangle, in the basis of the triangle laid flat
/// (`lay_flat`), unit length; zero where the warp stands on the triangle. On a tile that runs round, where these would
/// cancel, one direction on the cloth (`lay_on_cloth`).
Eigen::Matrix2Xd warp_in_triangles(const Tile& tile);

/// What the cloth of a triangle is to be (#F): the triangle laid flat (`lay_flat`), longer along warp and weft by the
/// compensation. Without one it is the surface's own triangle.
std::vector<Mat22> target_triangles(const Tile& tile);

/// How long each boundary edge is drawn [m], boundary[i] to boundary[i + 1]: on its seam's curve where that is known.
Eigen::VectorXd drawn_lengths(const Tile& tile);

/// How long each boundary edge is to be on the cloth [m]: drawn length and compensation.
Eigen::VectorXd target_lengths(const Tile& tile);

/// Lengths of the edges of a chain or loop [m], on the surface and on the cloth.
Eigen::VectorXd edge_lengths(const Points3& positions, const std::vector<int>& vertices);
Eigen::VectorXd edge_lengths(const Points2& positions, const std::vector<int>& vertices);

/// The loop closed: its first vertex once more at the end.
std::vector<int> closed(std::vector<int> loop);

}  // namespace ripstop
