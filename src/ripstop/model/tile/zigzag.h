#pragma once

#include <string>
#include <vector>

namespace ripstop {

/// A run of a tile's boundary that follows mesh edges where a smooth cut was meant: it turns alternately left and
/// right, with teeth about as high as its edges are long. Each edge keeps its length on the cloth while the teeth
/// fold like an accordion, so the sum of the edges says nothing about the seam.
struct Zigzag {
    int tile = 0;
    std::string tile_name;
    std::string mate;           ///< name of the tile on the other side; empty: none
    bool closed = false;        ///< it goes round the whole boundary
    int first = 0;              ///< index of its start in `Tile::boundary`
    std::vector<int> vertices;  ///< vertices of the tile's mesh, in boundary order; a closed run does not repeat its
                                ///< first
    std::vector<std::string> seams;  ///< ids of the seams along it, in boundary order
    double length = 0;               ///< total length of its edges [m]
    double fair_length = 0;  ///< length of the smooth curve that it stands for, on the surface (`FairCurve`) [m]
    double teeth = 0;        ///< largest height of a vertex over the line between its neighbours [m]

    std::string seams_text() const;  ///< ` (S0003 to S0041)`; empty if no seam lies along it
};

/// The accuracy of a zigzag on the cloth, measured on the curve that it stands for.
struct ZigzagWalk {
    Zigzag zigzag;
    double length = 0;       ///< length of the fair curve in space, the target on the cloth [m]
    double flat_length = 0;  ///< length of its image on the cloth [m]; NaN if the tile was not flattened
    double area = 0;         ///< area of the tile inside the fair curves of all its zigzags, on the surface [m2]
    double flat_area = 0;    ///< the same on the cloth [m2]

    double error() const { return flat_length / length - 1; }  ///< positive: too long on the cloth
};

}  // namespace ripstop
