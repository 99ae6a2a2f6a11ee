#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/model/tile/tile.h"

namespace ripstop {

/// How a tile is one that came before it, somewhere else.
struct Likeness {
    int to = -1;                  ///< the earlier tile; -1: this one is the first of its kind
    bool mirrored = false;        ///< it is that one's mirror image
    bool grain_reversed = false;  ///< its warp points the other way; a thread has no head, so the cloth is the same
    Eigen::Isometry3d motion =
        Eigen::Isometry3d::Identity();  ///< from the earlier tile (mirrored: its x -> -x) to this
    std::vector<int> vertex =
        {};  ///< of the earlier tile, the place of each of this one's vertices; empty where the two are
             ///< meshed differently, or lie apart by more than 1e-9 m
};

/// Which tiles are the same cut: alike up to a turn and a shift, or up to a mirror too (rights and lefts), in surface,
/// drawn edge lengths, corners, warp, fabric and compensation. Names and numbering of vertices do not matter.
///
/// Two tiles are the same surface where, after the rigid fit of their outlines (32 points a chain, least squares), no
/// vertex of either is farther than `tolerance` from the other's triangles. Chains' lengths must agree to `tolerance`,
/// the warp to `tolerance` at the tile's far end. Always compared with the first of a kind, so likeness does not creep.
///
/// Candidates are found by area, perimeter and number of chains: O(#tiles log #tiles) and, for each pair compared,
/// about O(#F log #F) where the meshes correspond vertex by vertex, O(#V #F) otherwise.
std::vector<Likeness> find_equal_tiles(const std::vector<Tile>& tiles, double tolerance = 1e-4);

}  // namespace ripstop
