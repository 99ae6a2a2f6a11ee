#pragma once

#include "ripstop/design/gores.h"

namespace ripstop {

/// What a design came out as: the tiles as drawn, beside the equilibrium they are drawn from.
struct DesignSummary {
    int tiles = 0;
    int panels = 0;  ///< in a gore
    int triangles = 0;
    int euler = 0;        ///< of the tiles welded where they share positions: 2 closed, 1 with one opening, 0 with two
    int openings = 0;     ///< boundary loops of the welded whole
    double area = 0;      ///< of the triangles [m2]
    double volume = 0;    ///< within the triangles and a flat cap on each opening [m3]
    double height = 0;    ///< lowest to highest vertex [m]
    double diameter = 0;  ///< twice the greatest distance of a vertex from the axis [m]
    double panel_height = 0;  ///< along the meridian [m]
    double panel_width = 0;   ///< widest cloth across a gore [m]
    double edge_min = 0;      ///< shortest and longest edge of any triangle [m]
    double edge_max = 0;
    double angle_min = 0;    ///< smallest angle of any triangle [rad]
    double turn_max = 0;     ///< largest angle between triangles that share an edge within a tile [rad]
    double chord_error = 0;  ///< largest distance of chord and arc across such an edge: turn height / 8 [m]
    NaturalShape shape;
};

/// Measures the tiles that `design_natural(design)` gave. O(#F log #F).
DesignSummary measure_design(const EnvelopeDesign& design, const std::vector<NamedMesh>& tiles);

/// One mesh of all tiles, vertices at the same place (bit for bit) made one.
TriangleMesh welded(const std::vector<NamedMesh>& tiles);

}  // namespace ripstop
