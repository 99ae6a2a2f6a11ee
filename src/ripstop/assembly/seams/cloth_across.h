#pragma once

#include <map>
#include <memory>
#include <vector>

#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/model/tile/seam.h"

namespace ripstop {

/// Distinguishes the two edges of a strip from two edges that miss each other: cloth lies straight across a strip.
///
/// From one place of a boundary, a walk crosses the triangles in the plane that contains the other place and the
/// surface's normal. It ends at the first boundary edge; if seams are known and that edge is sewn, it continues on
/// the next tile. Cloth joins the two places if the walk ends at the other one within twice their distance. So a
/// channel that is open by half its width or more is a strip, and a tube with a slit is not. At a gap the cloth
/// lies on the far sides, so the walk cannot start. At an overlap it passes under the other edge.
class ClothAcross {
  public:
    /// Keeps references to both arguments.
    ClothAcross(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains);
    ~ClothAcross();

    /// From now on, walks cross these seams.
    void cross(const std::vector<Seam>& seams);

    /// True if cloth joins the two places of a touch. False if a tile is an outline without triangles.
    /// O(#triangles crossed), plus O(#F log #F) once for each tile. Not thread-safe.
    bool joins(const Touch& touch) const;

    bool in_one_tile(const Touch& touch) const;

    /// The mean width of a chain's tile, twice its area over its boundary: the width of a strip, half the side of
    /// a square [m].
    double width_at(int chain) const;

  private:
    struct WalkPlane;
    struct WalkState;
    struct Surface;
    struct WalkEnd;
    const Surface& surface(int tile) const;
    WalkEnd place_on(int chain, double at) const;
    int set_out(const WalkPlane& plane, const WalkEnd& from, WalkState& walk) const;
    int cross_seam(const WalkPlane& plane, int edge, double reach, WalkState& walk) const;
    bool walk_arrives(const WalkEnd& from, const WalkEnd& to, bool zero_is_left) const;

    const std::vector<Tile>& tiles_;
    const std::vector<PlacedChain>& chains_;
    std::map<std::pair<int, int>, std::vector<const SeamSide*>> mates_;  ///< by tile and boundary edge: the other sides
    mutable std::map<int, std::unique_ptr<Surface>> surfaces_;
};

}  // namespace ripstop
