#pragma once

#include <optional>
#include <string>
#include <vector>

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
    double warp = 0, weft = 0;        ///< extra length of the whole cloth along warp and weft, each in (-0.5, 1)
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

}  // namespace ripstop
