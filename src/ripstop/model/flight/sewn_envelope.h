#pragma once

#include <array>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// One term of a place: `weight` times the position of a node, rotated by `turns` sectors about the vertical axis.
struct NodeShare {
    int node = 0;
    double weight = 1;
    int turns = 0;
};

/// A point of the sewn envelope: a sum of terms whose weights sum to 1, plus a constant offset.
struct SewnPoint {
    std::vector<NodeShare> shares = {};
    Vec3 offset = Vec3::Zero();  ///< [m]

    /// True if it moves as one node does, perhaps turned.
    bool is_node() const { return shares.size() == 1; }
};

/// The axes along which a node may move: x 1, y 2, z 4.
enum class Freedom : unsigned char { nowhere = 0, x = 1, y = 2, xy = 3, vertical = 4, xz = 5, yz = 6, everywhere = 7 };

/// True if a node with this freedom may move along the axis: 0 is x, 1 is y, 2 is z.
inline bool may_move(Freedom freedom, int axis) {
    return (static_cast<unsigned>(freedom) >> axis & 1u) != 0;
}

/// The kinds of tape: a load tape lies in a seam, a wire runs from the mouth to the burner frame, a tie joins two
/// points inside.
enum class TapeKind { load, wire, tie };

/// A straight piece of tape between two points.
struct SewnTape {
    TapeKind kind = TapeKind::load;
    SewnPoint a = {}, b = {};
    double rest = 0;       ///< length at rest [m]
    double stiffness = 0;  ///< EA [N]
    double mass = 0;       ///< [kg/m]
    int source = -1;       ///< load: seam in `CutPlan::seams`; tie: index in `Rigging::ties`; wire: its number
};

/// The pieces joined along their seams: the cloth at rest as cut, and how its points are connected in space. Heights
/// are those of the drawing; x and y are relative to the axis of symmetry, if there is one.
struct SewnEnvelope {
    Points3 nodes;                 ///< #N x 3: as drawn [m]
    std::vector<Freedom> freedom;  ///< freedom of each node
    int sectors = 1;               ///< equal sectors about the vertical axis; one of them is simulated
    Vec3 origin = Vec3::Zero();    ///< origin in the drawing's coordinates [m]

    std::vector<int> first_vertex;  ///< index of the first vertex of each tile in `places`
    std::vector<SewnPoint> places;  ///< place of every vertex of every tile

    Triangles triangles;          ///< #F x 3, indices into `places`: the tiles of one sector
    std::vector<Mat22> flat;      ///< of each triangle: its edges b - a and c - a as cut [m]
    std::vector<int> tile;        ///< tile of each triangle
    std::vector<int> fabric;      ///< fabric of each triangle, in `fabrics`
    std::vector<char> holds_gas;  ///< of each triangle: whether gas acts on its inner side only
    std::vector<Fabric> fabrics;

    std::vector<std::array<SewnPoint, 3>> caps;  ///< triangles that close an opening against the gas, without stiffness
    std::vector<std::array<SewnPoint, 3>> lids;  ///< triangles over openings that stay open: they only bound the volume
    double cap_mass = 0;                         ///< [kg/m2]
    std::vector<SewnTape> tapes;
    std::vector<int> held;  ///< nodes whose reaction forces carry what hangs below
    double floor = 0;       ///< height of the mouth plane [m]
    double seam_gap = 0;    ///< largest distance between two sides of a seam as drawn [m]
};

/// The point rotated by `turns` sectors of `angle` [rad] about the vertical axis.
Vec3 turned(const Vec3& x, int turns, double angle);

/// The position of a place for the given node positions; `angle` [rad] is that of a sector.
Vec3 position(const SewnPoint& place, const Points3& nodes, double angle);

}  // namespace ripstop
