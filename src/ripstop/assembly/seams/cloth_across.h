#pragma once

#include <map>
#include <memory>
#include <vector>

#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/model/tile/seam.h"

namespace ripstop {

/// Tells the two edges of a strip from two edges that miss each other: straight across, from one place of a boundary to
/// another, lies cloth.
///
/// From the one place a walk goes over the triangles, in the plane that holds the other place and the surface's normal.
/// It ends at the first boundary edge, or goes on in the next tile where seams are known and the edge is sewn. Cloth
/// joins the two places where the walk ends at the other one within twice their distance: a channel that is open by
/// half its width or more is a strip, a tube with a slit is not. In a gap the cloth lies on the far sides and the walk
/// does not begin; in an overlap it runs on beneath the other edge.
class ClothAcross {
  public:
    /// Keeps references to both.
    ClothAcross(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains);
    ~ClothAcross();

    /// Walks go on across these seams from now on.
    void cross(const std::vector<Seam>& seams);

    /// Does cloth join the two places of a touch? None does where a tile is an outline without triangles. O(#triangles
    /// crossed), and O(#F log #F) once a tile. Not to be asked by several threads at once.
    bool joins(const Touch& touch) const;

    bool in_one_tile(const Touch& touch) const;

    /// How wide the tile of a chain is in the mean, twice its area over its boundary: of a strip its width, of a square
    /// half its side [m].
    double width_at(int chain) const;

  private:
    struct WalkPlane;
    struct WalkState;
    struct Surface;
    struct Place;
    const Surface& surface(int tile) const;
    Place place_on(int chain, double at) const;
    int set_out(const WalkPlane& plane, const Place& from, WalkState& walk) const;
    int cross_seam(const WalkPlane& plane, int edge, double reach, WalkState& walk) const;
    bool walk_arrives(const Place& from, const Place& to, bool zero_is_left) const;

    const std::vector<Tile>& tiles_;
    const std::vector<PlacedChain>& chains_;
    std::map<std::pair<int, int>, std::vector<const SeamSide*>> mates_;  ///< by tile and boundary edge: the other sides
    mutable std::map<int, std::unique_ptr<Surface>> surfaces_;
};

}  // namespace ripstop
