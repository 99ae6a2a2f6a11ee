#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "ripstop/io/dxf_tags.h"
#include "ripstop/model/pattern_drawing.h"

namespace ripstop {

/// Points in a row, an arc a point a degree.
struct DxfShape {
    std::vector<Vec2> points;
    bool is_closed = false;
};

/// LINE, ARC, CIRCLE and LWPOLYLINE in their own plane. `most` as in `dxf_polyline`.
DxfShape dxf_shape(const DxfEntity& entity);

/// A POLYLINE with the VERTEX entities behind it; `next` is moved beyond its SEQEND. Requires one that is no mesh.
DxfShape dxf_polyline(const DxfEntity& head, DxfTagSpan tags, std::size_t& next, const std::string& name);

}  // namespace ripstop
