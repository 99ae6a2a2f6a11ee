#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The kinds of solid in a special shape (`SpecialPrimitive`).
enum class PrimitiveKind { ellipsoid, torus, capsule, cone };

/// A solid that is part of a special shape. Its local z axis is `axis`. Its local x axis is the projection of the
/// world's +x onto the plane across the axis (+y if the axis is along x), rotated by `turn` about the axis.
///
///     ellipsoid  radii along its local x, y, z
///     torus      about its axis: `radius` from the centre to the middle of the tube, `tube_radius`
///     capsule    the points within `radius` of a segment of `length` along the axis, centred
///     cone       from a disk of `radius` round the centre to one of `top_radius` (0: a point), `length` along the axis
///
/// Seams: half-planes from the axis at equal angles, the first through local x, divide it into `sectors`. Planes
/// across the axis divide its profile into `rings` of equal arc length, counted along the axis. The rings of a torus
/// divide its tube at equal angles, from its outermost circle up. The flat ends of a cone have no rings.
struct SpecialPrimitive {
    std::string name;
    PrimitiveKind kind = PrimitiveKind::ellipsoid;
    Vec3 centre = Vec3::Zero();  ///< [m]
    Vec3 axis = Vec3::UnitZ();   ///< any non-zero length
    double turn = 0;             ///< [rad]
    Vec3 radii = Vec3::Ones();   ///< semi-axes of an ellipsoid [m]
    double radius = 1;           ///< [m]
    double tube_radius = 0.25;   ///< [m]
    double length = 1;           ///< [m]
    double top_radius = 0;       ///< [m]
    int sectors = 1, rings = 1;

    /// The smallest feature that a mesh must resolve: a radius, or half the hole of a torus [m].
    double smallest_radius() const;
};

/// Primitives joined to one body, to be divided into tiles.
struct SpecialShape {
    std::vector<SpecialPrimitive> primitives;
    double edge_length = 0.3;     ///< target edge length of the triangles [m]
    double joint_radius = 0;      ///< radius of the fillet where primitives meet; 0: a sharp crease [m]
    std::optional<double> mouth;  ///< height of the plane below which the body is cut off [m]; empty: nowhere
};

/// Names in the order of PrimitiveKind.
inline constexpr const char* primitive_kind_names[] = {"ellipsoid", "torus", "capsule", "cone"};

/// Throws InputError that begins with `place` unless the shape is valid: 1 to 200 primitives with distinct names of
/// letters, digits, - and _; every length positive (joint and top radius may be 0) and below 1 km; each axis
/// non-zero; 1 to 1000 sectors and rings; a hole in each torus; an edge length of at most half the smallest feature
/// of each primitive.
void require_valid(const SpecialShape& shape, const std::string& place);

}  // namespace ripstop
