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

/// A run of a tile's boundary from one corner to the next, both included, counter-clockwise seen from outside. A tile
/// without corners has one chain that ends where it starts.
struct Chain {
    std::vector<int> vertices;
    SeamType finish = default_hem();  ///< finish of the parts that are in no seam
    int edge_count() const { return static_cast<int>(vertices.size()) - 1; }
};

/// The warp of a tile: a direction in space, projected onto the surface (`lay_on_cloth`). `source` names its origin
/// for the report.
struct Grain {
    Vec3 direction = Vec3::UnitX();  ///< unit length
    std::string source;
    Points3 field = {};  ///< #F x 3: a unit direction per triangle; empty: `direction` for all
};

/// By how much the cloth is cut larger than drawn. Ratios: 0.005 is half a per cent longer. Cloth that shrinks in use
/// is cut longer, cloth that stretches shorter.
struct Compensation {
    double warp = 0, weft = 0;        ///< of the whole cloth along warp and weft, each in (-0.5, 1)
    std::vector<double> chains = {};  ///< of the edges only, in addition to warp and weft, one per chain; missing ones
                                      ///< are 0
    /// #F x 3: the Green strain E11, E22, 2 E12 (warp, weft) in flight. The cloth of each triangle is cut so that it
    /// has this strain in its drawn shape, before `warp` and `weft`; empty: none. Requires `edges` (#boundary): cloth
    /// per drawn length of each boundary edge, the same on both sides of a seam, also before the others.
    Points3 strain = {};
    Eigen::VectorXd edges = {};

    bool any() const { return warp != 0 || weft != 0 || !chains.empty() || strain.rows() > 0; }
};

/// A line drawn on a tile: a load tape, artwork, a mark.
struct SurfaceLine {
    std::string name;
    Points3 points;  ///< at least 2 x 3; on the surface, or as near to it as drawn [m]
};

/// A curved patch between seams: an oriented disk with corners, chains and a warp.
struct Tile {
    std::string name;
    TriangleMesh mesh;
    std::vector<int> boundary;  ///< loop of boundary vertices, counter-clockwise seen from outside
    std::vector<Chain> chains;  ///< they cover the boundary once, in order
    Grain grain;
    std::optional<Points2> drawn;  ///< #V x 2: flat positions from the input [m]
    Compensation compensation;
    Eigen::VectorXd curve_lengths;  ///< length of each boundary edge along the curve of its seam [m]; empty: the edge's
                                    ///< own length
    Attributes attributes = {};     ///< metadata from the file
    std::vector<SurfaceLine> lines = {};
    std::optional<Fabric> fabric = {};      ///< if it differs from the envelope's
    std::optional<Remeshed> remeshed = {};  ///< if its mesh is not the input's
    bool inside = false;                    ///< a diaphragm according to the project file, not part of the skin

    const Fabric& fabric_or(const Fabric& of_envelope) const { return fabric ? *fabric : of_envelope; }
};

/// Options of `make_tile` for corners and warp.
struct TileOptions {
    double corner_angle = 30 * degree;  ///< a boundary vertex with a larger turn is a corner [rad]
    std::vector<Vec3> corners = {};     ///< if any: replace the automatic corners by the boundary vertices nearest to
                                        ///< these points
    std::optional<Vec3> warp = {};      ///< default: the longest axis
    Points3 warp_field = {};            ///< #F x 3: a direction per triangle; used if no `warp` is given; may be empty
    std::string warp_source = "given";  ///< origin of the warp, in words
    std::optional<double> grain_turn = {};  ///< rotates the longest axis, counter-clockwise seen from outside [rad]
    std::optional<Points2> drawn = {};
    Compensation compensation = {};
    Attributes attributes = {};
};

/// Makes a tile of a mesh. Corners are where the boundary turns by more than `corner_angle` within the surface: pi
/// minus the sum of the triangle angles at the vertex, so a gentle curve in space is no corner. Throws InputError
/// (`require_disk`, or a warp normal to the surface).
Tile make_tile(std::string name, TriangleMesh mesh, const TileOptions& options = {});

/// The geodesic turning angle at each boundary vertex: pi minus the sum of the triangle angles there [rad]. Positive
/// turns left.
Eigen::VectorXd surface_turning(const TriangleMesh& mesh, const std::vector<int>& boundary);

/// The longest direction of a tile: the axis of largest second moment of its area, oriented towards +z (else +y, else
/// +x). If it is not unique, as round a tube, that of the unrolled tile (`longest_axis_on_cloth`).
Vec3 longest_axis(const TriangleMesh& mesh);

/// The warp in the frame of each triangle (2 x #F): its projection onto the triangle in the basis of `lay_flat`, with
/// unit length; zero if the warp is normal to the triangle. On a tile that goes right round, where these would
/// cancel, it is one direction on the cloth (`lay_on_cloth`).
Eigen::Matrix2Xd warp_in_triangles(const Tile& tile);

/// The target shape of each triangle on the cloth (#F): the triangle laid flat (`lay_flat`), scaled along warp and
/// weft by the compensation. Without compensation it is the triangle of the surface.
std::vector<Mat22> target_triangles(const Tile& tile);

/// The drawn length of each boundary edge, boundary[i] to boundary[i + 1] [m]: along its seam's curve if that is
/// known.
Eigen::VectorXd drawn_lengths(const Tile& tile);

/// The target length of each boundary edge on the cloth [m]: the drawn length with compensation.
Eigen::VectorXd target_lengths(const Tile& tile);

/// The edge lengths of a chain or loop [m], on the surface and on the cloth.
Eigen::VectorXd edge_lengths(const Points3& positions, const std::vector<int>& vertices);
Eigen::VectorXd edge_lengths(const Points2& positions, const std::vector<int>& vertices);

/// The loop with its first vertex repeated at the end.
std::vector<int> closed(std::vector<int> loop);

}  // namespace ripstop
