#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ripstop/io/text/png.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// From where the page sees the whole at first (apps/report/src/envelope/shape.js), in turned axes.
inline const Vec3 home_direction(0.55, 0.28, 1);

/// The tiles as report.html places them (apps/report/src/envelope/shape.js): x to the right, y up, z towards the
/// viewer. The input's z is up, or its y where the shape is much taller along it.
struct EnvelopeShape {
    std::vector<Points3> positions;  ///< of each tile's vertices [m]
    Vec3 centre = Vec3::Zero();
    double radius = 1;  ///< of the ball about the centre that holds all [m]
    bool is_y_up = false;

    Vec3 turned(const Vec3& p) const { return is_y_up ? p : Vec3(p.x(), p.z(), -p.y()); }
};
/// As drawn, or as inflated, which needs `plan.inflated`.
EnvelopeShape envelope_shape(const CutPlan& plan, bool is_inflated = false);

/// The envelope seen from afar in a square of pixels, before it is coloured: what is nearest in each of them. In front
/// of the cloth lie the band along the edges, thin outlines of the tiles, red ones of what fails, dashes for proposed
/// seams.
struct EnvelopeView {
    int side = 0;  ///< pixels of the square
    double pixels_per_metre = 1;
    Vec3 centre = Vec3::Zero(), right = Vec3::UnitX(), up = Vec3::UnitY(), towards = Vec3::UnitZ();
    std::vector<int> cloth;            ///< triangle, of all tiles one after the other; -1: none
    std::vector<int> band;             ///< boundary edge, likewise; -1: none is before the cloth
    std::vector<std::uint32_t> lines;  ///< 0xRRGGBB; `no_line`: none
    static constexpr std::uint32_t no_line = 0xff000000;

    /// Of a turned point: x and y in pixels, y down, and z, the depth, which grows towards the viewer.
    Vec3 at(const Vec3& point) const;
};

/// Seen from `direction` (turned axes) without perspective, so that one scale holds for all of it, as large as fits
/// into a square of `side` pixels. Nothing is painted yet.
EnvelopeView aimed_view(const EnvelopeShape& shape, const Vec3& direction, int side);

/// Paints it. `line_width`: of the thin outlines [pixels]. Cost: O(triangles + pixels).
void paint_envelope(EnvelopeView& view, const CutPlan& plan, const EnvelopeShape& shape, double line_width);

/// The pixels of a view in the colours of a map, in the scale it is shown in.
Pixels coloured(const EnvelopeView& view, const CutPlan& plan, const MapView& map);

}  // namespace ripstop
