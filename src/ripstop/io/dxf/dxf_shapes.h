#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/io/dxf/dxf_tags.h"
#include "ripstop/model/piece/pattern_drawing.h"

namespace ripstop {

/// Points in a row. Curves are sampled: no chord is farther from its curve than the chord error [file's units], and
/// circles have at least a point a degree.
struct DxfShape {
    std::vector<Vec3> points;
    bool is_closed = false;
};

/// LINE, ARC, CIRCLE, ELLIPSE and LWPOLYLINE; those of a plane in the coordinates of their plane (`dxf_plane`).
DxfShape dxf_shape(const DxfEntity& entity, double chord_error);

/// A POLYLINE with the VERTEX entities behind it; `next` is moved beyond its SEQEND. Requires one that is no mesh.
DxfShape dxf_polyline(const DxfEntity& head, DxfTagSpan tags, std::size_t& next, const std::string& name,
                      double chord_error);

/// A SPLINE or HELIX of any degree, rational or not, by its control points and knots; where it has none they are
/// uniform and clamped. One that only says the points it goes through is the cubic spline whose parameter is the length
/// of the chords, with its tangents at the ends, else 3 q1 - q2 of the two chords there (as ezdxf, near to BricsCAD).
/// No point where neither makes a curve.
DxfShape dxf_spline(const DxfEntity& entity, double chord_error);

/// From the plane of an entity to space: its axes by the arbitrary axis algorithm of the DXF reference from the
/// extrusion direction (210, 220, 230). A rotation; the identity for what is drawn in space itself.
Eigen::Matrix3d dxf_plane(const DxfEntity& entity);

}  // namespace ripstop
