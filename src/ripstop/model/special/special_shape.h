#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The solids that a special shape is joined of (`SpecialPrimitive`).
enum class PrimitiveKind { ellipsoid, torus, capsule, cone };

/// A solid of which a special shape is joined. Its own z runs along `axis`; its own x is what of the world's +x is
/// square to the axis (of +y where the axis is along x), turned by `turn` about the axis.
///
///     ellipsoid  radii along its own x, y, z
///     torus      about its axis: `radius` of the circle that the tube's middle runs on, `tube_radius`
///     capsule    the points within `radius` of a segment of `length` along the axis, the centre in its middle
///     cone       from a disk of `radius` round the centre to one of `top_radius` (0: a point), `length` along the axis
///
/// Seams: half-planes from the axis at equal angles, the first at its own x, make `sectors`; planes across the axis
/// that divide its outline into equal lengths make `rings`, counted along the axis. The rings of a torus divide its
/// tube at equal angles, from its outermost circle up. Flat ends of a cone have no rings.
struct SpecialPrimitive {
    std::string name;
    PrimitiveKind kind = PrimitiveKind::ellipsoid;
    Vec3 centre = Vec3::Zero();  ///< [m]
    Vec3 axis = Vec3::UnitZ();   ///< any length but zero
    double turn = 0;             ///< [rad]
    Vec3 radii = Vec3::Ones();   ///< of an ellipsoid [m]
    double radius = 1;           ///< [m]
    double tube_radius = 0.25;   ///< [m]
    double length = 1;           ///< [m]
    double top_radius = 0;       ///< [m]
    int sectors = 1, rings = 1;

    /// The smallest of its lengths that a mesh has to follow: a radius, or half the hole of a torus [m].
    double smallest_radius() const;
};

/// Primitives joined to one body, to be cut into tiles.
struct SpecialShape {
    std::vector<SpecialPrimitive> primitives;
    double edge_length = 0.3;     ///< of the triangles [m]
    double joint_radius = 0;      ///< of the fillet where primitives meet; 0: a sharp crease [m]
    std::optional<double> mouth;  ///< height of the plane below which the body is cut off [m]
};

/// In the order of PrimitiveKind.
inline constexpr const char* primitive_kind_names[] = {"ellipsoid", "torus", "capsule", "cone"};

/// Throws InputError that begins with `place` unless there are 1 to 200 primitives with names of letters, digits, - and
/// _, each once; every length is positive (joint and top radius: or 0) and below 1 km; each axis has a direction;
/// sectors and rings are 1 to 1000; a torus has a hole; the edge length is at most half of what each primitive has to
/// follow.
void require_valid(const SpecialShape& shape, const std::string& place);

}  // namespace ripstop
