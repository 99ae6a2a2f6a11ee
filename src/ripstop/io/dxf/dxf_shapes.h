#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/io/dxf/dxf_tags.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// A row of points. Curves are sampled: no chord is farther from its curve than the chord error [file's units],
/// and circles have at least one point per degree.
struct DxfShape {
    std::vector<Vec3> points;
    bool is_closed = false;
};

/// Reads LINE, ARC, CIRCLE, ELLIPSE and LWPOLYLINE. Plane entities are in the coordinates of their plane
/// (`dxf_plane`).
DxfShape dxf_shape(const DxfEntity& entity, double chord_error);

/// Reads a POLYLINE and the VERTEX entities after it. Moves `next` beyond the SEQEND. The POLYLINE must not be a
/// mesh.
DxfShape dxf_polyline(const DxfEntity& head, DxfTagSpan tags, std::size_t& next, const std::string& name,
                      double chord_error);

/// Reads a SPLINE or HELIX of any degree, rational or not, from its control points and knots; missing knots are
/// uniform and clamped. If only fit points are given, the curve is the cubic spline through them, parameterized by
/// chord length. Its end tangents are those of the entity, else 3 q1 - q2 of the two chords at that end (as in
/// ezdxf, close to BricsCAD). Returns no points if neither gives a curve.
DxfShape dxf_spline(const DxfEntity& entity, double chord_error);

/// The rotation from the plane of an entity to space. The arbitrary axis algorithm of the DXF reference gives its
/// axes from the extrusion direction (210, 220, 230). The identity for entities that are drawn in space.
Eigen::Matrix3d dxf_plane(const DxfEntity& entity);

}  // namespace ripstop
