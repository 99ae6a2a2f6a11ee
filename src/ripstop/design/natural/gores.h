#pragma once

#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/design/natural/natural_shape.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A natural-shape hot-air envelope of equal gores, each cut across into panels of equal length along the meridian.
struct EnvelopeDesign {
    int gores = 24;              ///< 3 to 1000
    int panels = 15;             ///< in a gore, mouth to crown, 1 to 1000
    double panel_height = 0;     ///< if > 0: as many panels as keep each at most this long, instead of `panels` [m]
    double volume = 3000;        ///< below the crown, as if closed [m3]
    double diameter = 0;         ///< if > 0: this largest diameter (of the tapes, where lobed) instead of `volume` [m]
    double mouth_ratio = 0.26;   ///< radius of the mouth over the largest, [0, 0.8]; 0: closed to a point
    double crown_radius = 0.25;  ///< of the opening at the top [m]; 0: closed to a point
    double bulge = 0;            ///< half-angle of the lobes [rad], 0 (a surface of revolution) to 60 degrees
    double edge_length = 0.15;   ///< of the triangles, where the gore is wide enough for it [m]
    double fabric_mass = 0.065;  ///< [kg/m2]
    Air air = {};
};

/// The shape that `design_natural` meshes. Throws InputError that names option, value and range; or that no such shape
/// exists (too heavy for its lift, or lobes too flat).
NaturalShape design_shape(const EnvelopeDesign& design);

/// A point of the design's surface: s along the meridian, gore 0 to gores - 1, u from -1 to 1 across the gore,
/// counter-clockwise seen from above; gore 0 starts at +x. u = +1 and u = -1 of the next gore are the same bits. z = 0
/// is the mouth plane.
///
/// Smooth: on the circle of radius r. Lobed: an arc of half-angle B between the tapes, in the plane of the meridian's
/// normal:
///
///     P = [r cos a, 0, z] + rho sin(u B) e_phi + rho (cos u B - cos B) n
///
/// with rho = r sin a / sin B and n = (cos th, 0, -sin th).
Vec3 design_point(const EnvelopeDesign& design, const MeridianPoint& at, int gore, double u);

/// The tiles `G01P01`, `G01P02`, ... gore by gore, panels from the mouth up (two digits, more where there are more).
///
/// Each tile is a disk of its own vertices, counter-clockwise from outside, symmetric about the middle of its gore, of
/// rows across whose triangles stand staggered. On a seam both tiles have vertices at the same places, bit for bit.
/// Towards a narrow end triangles get smaller, down to a third of `edge_length` along the meridian. Throws InputError
/// (`design_shape`; more than 20 million triangles asked for; a crown as wide as the envelope). Linear in the number of
/// triangles.
std::vector<NamedMesh> design_natural(const EnvelopeDesign& design);

/// The edge length that gives about so many triangles a tile on average [m].
double edge_length_for(const EnvelopeDesign& design, int triangles_per_tile);

}  // namespace ripstop
