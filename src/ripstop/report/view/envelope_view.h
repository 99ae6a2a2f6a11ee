#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ripstop/io/text/png.h"
#include "ripstop/model/plan/cut_plan.h"
#include "ripstop/report/view/map_view.h"

namespace ripstop {

/// The page's first view direction (apps/report/src/envelope/shape.js), in turned axes.
inline const Vec3 home_direction(0.55, 0.28, 1);

/// The tiles as placed by report.html (apps/report/src/envelope/shape.js): x to the right, y up, z towards the viewer.
/// Up is the input's z, or its y if the shape is much taller along y.
struct EnvelopeShape {
    std::vector<Points3> positions;  ///< per tile, its vertices [m]
    Vec3 centre = Vec3::Zero();
    double radius = 1;  ///< radius of the enclosing ball about the centre [m]
    bool is_y_up = false;

    Vec3 turned(const Vec3& p) const { return is_y_up ? p : Vec3(p.x(), p.z(), -p.y()); }
};
/// The shape as drawn, or as inflated (requires `plan.inflated`).
EnvelopeShape envelope_shape(const CutPlan& plan, bool is_inflated = false);

/// A parallel view of the envelope in a square of pixels, before colouring: the front-most element in each pixel. In
/// front of the cloth are the band along the edges, thin outlines of the tiles, red outlines of failing parts, and
/// dashes for proposed seams.
struct EnvelopeView {
    int side = 0;  ///< pixels of the square
    double pixels_per_metre = 1;
    Vec3 centre = Vec3::Zero(), right = Vec3::UnitX(), up = Vec3::UnitY(), towards = Vec3::UnitZ();
    std::vector<int> cloth;            ///< triangle, numbered over all tiles; -1: none
    std::vector<int> band;             ///< boundary edge, likewise; -1: none in front of the cloth
    std::vector<std::uint32_t> lines;  ///< 0xRRGGBB; `no_line`: none
    static constexpr std::uint32_t no_line = 0xff000000;

    /// Maps a turned point to pixels x and y (y down) and the depth z, which grows towards the viewer.
    Vec3 at(const Vec3& point) const;
};

/// A parallel view from `direction` (turned axes), so one scale holds everywhere, as large as fits into a square of
/// `side` pixels. Nothing is painted yet.
EnvelopeView aimed_view(const EnvelopeShape& shape, const Vec3& direction, int side);

/// Paints the view. `line_width`: of the thin outlines [pixels]. O(triangles + pixels).
void paint_envelope(EnvelopeView& view, const CutPlan& plan, const EnvelopeShape& shape, double line_width);

/// The pixels of a view, coloured by a map in its first scale.
Pixels coloured(const EnvelopeView& view, const CutPlan& plan, const MapView& map);

}  // namespace ripstop
