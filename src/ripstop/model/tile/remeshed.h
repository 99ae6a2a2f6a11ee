#pragma once

#include <string>

namespace ripstop {

/// Why and how a tile was remeshed.
struct Remeshed {
    std::string reason;           ///< a few words: `edges turn by up to 14 degrees`
    int triangles_before = 0;     ///< triangles of the input's mesh
    double edge_length = 0;       ///< target edge length [m]
    double turn_max = 0;          ///< largest turn of the input's mesh between edges or triangles [rad]
    double area_before = 0;       ///< area of the input's triangles [m2]
    double perimeter_before = 0;  ///< length of the input's boundary edges [m]
    double distance_max = 0;      ///< largest distance of the new vertices from the input's triangles [m]
};

}  // namespace ripstop
