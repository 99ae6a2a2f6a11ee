#include "ripstop/nest/laid_shape.h"

#include <cmath>
#include <polyclipping/clipper.hpp>

#include "ripstop/geometry/simplify.h"

namespace ripstop {
namespace {

constexpr double steps_per_metre = 1e7;
constexpr double left_out = 1e-4;          // [m] points this close to a line are left out
constexpr double clipper_rounding = 1e-6;  // [m] more than Clipper's rounding

Points2 closed(const Points2& outline) {
    Points2 line(outline.rows() + 1, 2);
    line << outline, outline.row(0);
    return line;
}

}  // namespace

Points2 grown_outline(const Points2& outline, double distance) {
    const Points2 line = simplified(closed(outline), left_out);
    ClipperLib::Path path;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i)
        path.emplace_back(std::llround(line(i, 0) * steps_per_metre), std::llround(line(i, 1) * steps_per_metre));
    ClipperLib::ClipperOffset offset(2);
    offset.AddPath(path, ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
    ClipperLib::Paths grown;
    offset.Execute(grown, (distance + left_out + clipper_rounding) * steps_per_metre);
    if (grown.empty()) return outline;
    // Takes the outer contour. Growing may close a hollow; the hole left inside it is not used.
    std::size_t largest = 0;
    for (std::size_t i = 1; i < grown.size(); ++i)
        if (ClipperLib::Area(grown[i]) > ClipperLib::Area(grown[largest])) largest = i;
    Points2 result(static_cast<Eigen::Index>(grown[largest].size()), 2);
    for (std::size_t i = 0; i < grown[largest].size(); ++i)
        result.row(static_cast<Eigen::Index>(i)) << static_cast<double>(grown[largest][i].X) / steps_per_metre,
            static_cast<double>(grown[largest][i].Y) / steps_per_metre;
    return result;
}

}  // namespace ripstop
