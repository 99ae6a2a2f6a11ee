#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// The relation of a tile to an earlier tile that is congruent to it.
struct Likeness {
    int to = -1;                  ///< the earlier tile; -1: this one is the first of its kind
    bool mirrored = false;        ///< the two are mirror images
    bool grain_reversed = false;  ///< its warp points the other way; a thread has no direction, so the cloth is the
                                  ///< same
    Eigen::Isometry3d motion =
        Eigen::Isometry3d::Identity();  ///< from the earlier tile (mirrored: with x -> -x) to this one
    std::vector<int> vertex =
        {};  ///< vertex of the earlier tile for each of this one's vertices; empty if the two are meshed differently,
             ///< or lie more than 1e-9 m apart
};

/// Finds tiles with the same pattern: equal in surface, drawn edge lengths, corners, warp, fabric and compensation, up
/// to a rigid motion or a reflection (a left and a right piece). Names and vertex numbering do not matter.
///
/// Two tiles have the same surface if, after the rigid fit of their outlines (32 points per chain, least squares), no
/// vertex of either is farther than `tolerance` from the other's triangles. Chain lengths must agree to `tolerance`,
/// and the warp to `tolerance` at the far end of the tile. Tiles are always compared with the first of a kind, so
/// errors do not accumulate.
///
/// Candidates are found by area, perimeter and number of chains: O(#tiles log #tiles). A comparison costs about O(#F
/// log #F) if the meshes correspond vertex by vertex, otherwise O(#V #F).
std::vector<Likeness> find_equal_tiles(const std::vector<Tile>& tiles, double tolerance = 1e-4);

}  // namespace ripstop
