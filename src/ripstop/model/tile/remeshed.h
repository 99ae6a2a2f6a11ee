#pragma once

#include <string>

namespace ripstop {

/// How a tile came by another mesh than the input's.
struct Remeshed {
    std::string reason;           ///< a few words: `edges turn by up to 14 degrees`
    int triangles_before = 0;     ///< of the input's mesh
    double edge_length = 0;       ///< aimed at [m]
    double turn_max = 0;          ///< largest turn of the input's mesh from edge to edge or triangle to triangle [rad]
    double area_before = 0;       ///< of the input's triangles [m2]
    double perimeter_before = 0;  ///< of the input's boundary edges [m]
    double distance_max = 0;      ///< of the new vertices from the input's triangles [m]
};

}  // namespace ripstop
