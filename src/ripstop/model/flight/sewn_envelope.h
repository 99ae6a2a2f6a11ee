#pragma once

#include <array>
#include <vector>

#include "ripstop/geometry/types.h"
#include "ripstop/model/tile/fabric.h"

namespace ripstop {

/// A share in a point: `weight` times the place of a node, turned by `turns` sectors about the vertical axis.
struct PlacePart {
    int node = 0;
    double weight = 1;
    int turns = 0;
};

/// A point of the sewn envelope: the sum of its parts, whose weights sum to 1, and a way off that stays as it is.
struct Place : std::vector<PlacePart> {
    using std::vector<PlacePart>::vector;
    Vec3 offset = Vec3::Zero();  ///< [m]
};

/// Along which axes a node may go: x 1, y 2, z 4.
enum class Freedom : unsigned char { nowhere = 0, x = 1, y = 2, xy = 3, vertical = 4, xz = 5, yz = 6, everywhere = 7 };

/// True if a node with this freedom may move along the axis: 0 is x, 1 is y, 2 is z.
inline bool may_move(Freedom freedom, int axis) {
    return (static_cast<unsigned>(freedom) >> axis & 1u) != 0;
}

/// What a tape does: a load tape lies in a seam, a wire runs from the mouth to the burner frame, a tie joins two points
/// inside.
enum class TapeKind { load, wire, tie };

/// A straight piece of tape between two points.
struct SewnTape {
    TapeKind kind = TapeKind::load;
    Place a = {}, b = {};
    double rest = 0;       ///< length at rest [m]
    double stiffness = 0;  ///< EA [N]
    double mass = 0;       ///< [kg/m]
    int source = -1;       ///< load: the seam, in `CutPlan::seams`; tie: in `Rigging::ties`; wire: its number
};

/// The pieces joined along their seams: cloth at rest as it was cut, and how its points hang together in space. Heights
/// are the drawing's; x and y are from the axis of symmetry, where there is one.
struct SewnEnvelope {
    Points3 nodes;                 ///< #N x 3: as drawn [m]
    std::vector<Freedom> freedom;  ///< of each node
    int sectors = 1;               ///< equal sectors about the vertical axis; one of them is simulated
    Vec3 origin = Vec3::Zero();    ///< of the drawing's coordinates [m]

    std::vector<int> first_vertex;  ///< of each tile of the plan, in `places`
    std::vector<Place> places;      ///< of every vertex of every tile

    Triangles triangles;          ///< #F x 3 into `places`: the tiles of one sector
    std::vector<Mat22> flat;      ///< of each triangle: its edges b - a, c - a as cut [m]
    std::vector<int> tile;        ///< of each triangle
    std::vector<int> fabric;      ///< of each triangle, in `fabrics`
    std::vector<char> holds_gas;  ///< of each triangle: gas on its inner side only
    std::vector<Fabric> fabrics;

    std::vector<std::array<Place, 3>> caps;  ///< triangles that close an opening against the gas, without stiffness
    std::vector<std::array<Place, 3>>
        lids;             ///< triangles over the openings that stay open: they bound the volume, no more
    double cap_mass = 0;  ///< [kg/m2]
    std::vector<SewnTape> tapes;
    std::vector<int> held;  ///< nodes whose reaction is what hangs below
    double floor = 0;       ///< the mouth plane [m]
    double seam_gap = 0;    ///< largest distance between two sides of a seam as drawn [m]
};

/// Turned by so many sectors of `angle` [rad] about the vertical axis.
Vec3 turned(const Vec3& x, int turns, double angle);

/// Where a place is, for nodes at `nodes`, `angle` [rad] a turn.
Vec3 position(const Place& place, const Points3& nodes, double angle);

}  // namespace ripstop
