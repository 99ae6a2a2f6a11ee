#include "ripstop/geometry/corners.h"

#include <cmath>

namespace ripstop {

std::vector<int> sharp_corners(const Points2& polygon, double turn) {
    std::vector<int> kept;
    const int count = static_cast<int>(polygon.rows());
    for (int i = 0; i < count; ++i)
        if (kept.empty() || polygon.row(i) != polygon.row(kept.back())) kept.push_back(i);
    while (kept.size() > 1 && polygon.row(kept.back()) == polygon.row(kept.front())) kept.pop_back();
    std::vector<int> corners;
    const std::size_t points = kept.size();
    if (points < 2) return corners;
    for (std::size_t k = 0; k < points; ++k) {
        const Vec2 here = polygon.row(kept[k]);
        const Vec2 in = here - Vec2(polygon.row(kept[(k + points - 1) % points]));
        const Vec2 out = Vec2(polygon.row(kept[(k + 1) % points])) - here;
        const double angle = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        if (std::abs(angle) > turn) corners.push_back(kept[k]);
    }
    return corners;
}

}  // namespace ripstop
