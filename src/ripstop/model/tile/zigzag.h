#pragma once

#include <string>
#include <vector>

#include "ripstop/geometry/fair_curve.h"
#include "ripstop/model/tile/envelope.h"

namespace ripstop {

/// A run of a tile's boundary that goes along the edges of a mesh where a smooth cut was meant: it turns left and right
/// in turn, by teeth about as high as its edges are long. Each edge keeps its length on the cloth while the teeth fold
/// like an accordion, so their sum says nothing of the seam.
struct Zigzag {
    int tile = 0;
    std::string tile_name;
    std::string mate;           ///< name of the tile it is sewn to; empty: none
    bool closed = false;        ///< it goes round the whole boundary
    int first = 0;              ///< where it begins, in `Tile::boundary`
    std::vector<int> vertices;  ///< of the tile's mesh, in the boundary's order; a closed one does not repeat its first
    std::vector<std::string> seams;  ///< ids of those that lie along it, in the boundary's order
    double length = 0;               ///< of its edges [m]
    double fair_length = 0;          ///< of the curve that it stands for, on the surface (`FairCurve`) [m]
    double teeth = 0;                ///< the largest height of a vertex over the line between its neighbours [m]

    std::string seams_text() const;  ///< ` (S0003 to S0041)`; empty where no seam lies along it
};

/// What became of a zigzag on the cloth, by the curve that it stands for.
struct ZigzagWalk {
    Zigzag zigzag;
    double length = 0;       ///< of the fair curve in space, as long as the cloth is to be there [m]
    double flat_length = 0;  ///< of its image on the cloth [m]; not a number where the tile was not flattened
    double area = 0;         ///< of the tile within the fair curves of all its zigzags, on the surface [m2]
    double flat_area = 0;    ///< the same on the cloth [m2]

    double error() const { return flat_length / length - 1; }  ///< positive: too long on the cloth
};

/// The zigzags of each tile, in the order of the tiles and their boundaries.
///
/// A run lies between one neighbour's end and the next, and between corners that were given. Its turns of more than 6
/// degrees on the surface follow one another by at most six edges, at least four of them and at least 11 in 20 change
/// the side, its teeth are at most a quarter as high as the whole is large, and its fair curve (`FairCurve`) stays
/// within an edge of it. So a corner, a curve however coarse, and a hem whose scallops are many edges wide are none.
/// O(#boundary).
std::vector<Zigzag> find_zigzags(const std::vector<const Tile*>& tiles, const std::vector<Seam>& seams);
std::vector<Zigzag> find_zigzags(const std::vector<Tile>& tiles, const std::vector<Seam>& seams);

/// The zigzag as it lies on the surface; `turning` of its tile's boundary (`surface_turning`).
ChainLayout layout_of(const Zigzag& zigzag, const Tile& tile, const Eigen::VectorXd& turning);

}  // namespace ripstop
