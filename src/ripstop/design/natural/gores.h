#pragma once

#include <vector>

#include "ripstop/base/text/units.h"
#include "ripstop/design/natural/natural_shape.h"
#include "ripstop/model/tile/cad_model.h"

namespace ripstop {

/// A natural-shape hot-air envelope of equal gores. Each gore is cut into panels of equal length along the meridian.
struct EnvelopeDesign {
    int gores = 24;              ///< 3 to 1000
    int panels = 15;             ///< panels per gore, mouth to crown, 1 to 1000
    double panel_height = 0;     ///< if > 0, replaces `panels`: as many panels as keep each at most this long [m]
    double volume = 3000;        ///< enclosed volume below the crown, as if closed [m3]
    double diameter = 0;         ///< if > 0, replaces `volume`: the largest diameter (of the tapes if lobed) [m]
    double mouth_ratio = 0.26;   ///< radius of the mouth relative to the largest, [0, 0.8]; 0: closed to a point
    double crown_radius = 0.25;  ///< radius of the opening at the top [m]; 0: closed to a point
    double bulge = 0;            ///< half-angle of the lobes [rad], 0 (a surface of revolution) to 60 degrees
    double edge_length = 0.15;   ///< target edge length of the triangles, where the gore is wide enough [m]
    double fabric_mass = 0.065;  ///< [kg/m2]
    Air air = {};
};

/// The shape that `design_natural` meshes. Throws InputError that names option, value and range, or says that no such
/// shape exists (too heavy for its lift, or lobes too flat).
NaturalShape design_shape(const EnvelopeDesign& design);

/// A point of the design's surface: s along the meridian, gore 0 to gores - 1, u from -1 to 1 across the gore,
/// counter-clockwise seen from above; gore 0 starts at +x. u = +1 and u = -1 of the next gore agree bit for bit.
/// z = 0 is the mouth plane.
///
/// Smooth: the point lies on the circle of radius r. Lobed: it lies on an arc of half-angle B between the tapes, in
/// the plane of the meridian's normal:
///
///     P = [r cos a, 0, z] + rho sin(u B) e_phi + rho (cos u B - cos B) n
///
/// with rho = r sin a / sin B and n = (cos th, 0, -sin th).
Vec3 design_point(const EnvelopeDesign& design, const MeridianPoint& at, int gore, double u);

/// The tiles `G01P01`, `G01P02`, ... gore by gore, panels from the mouth up (at least two digits).
///
/// Each tile is a disk with its own vertices, counter-clockwise from outside, symmetric about the middle of its gore,
/// with staggered rows of triangles. On a seam both tiles have vertices at the same places, bit for bit. Towards a
/// narrow end the triangles become smaller, down to a third of `edge_length` along the meridian. Throws InputError
/// (`design_shape`; more than 20 million triangles; a crown as wide as the envelope). Linear in the number of
/// triangles.
std::vector<NamedMesh> design_natural(const EnvelopeDesign& design);

/// The edge length that gives about `triangles_per_tile` triangles per tile on average [m].
double edge_length_for(const EnvelopeDesign& design, int triangles_per_tile);

}  // namespace ripstop
