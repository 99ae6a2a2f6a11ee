#include "ripstop/mesh/fan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace ripstop {
namespace {

/// The smallest component along `normal` of the area vectors of the fan from `corner`, twice an area. Negative
/// infinity if a triangle faces against the one before it, as in a bow tie, whose area vector is the difference of
/// its two wings.
double thinnest(const std::vector<Vec3>& polygon, std::size_t corner, const Vec3& normal, double tiny) {
    const std::size_t count = polygon.size();
    double smallest = std::numeric_limits<double>::infinity();
    Vec3 before = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < count; ++k) {
        const Vec3 b = polygon[(corner + k) % count] - polygon[corner];
        const Vec3 c = polygon[(corner + k + 1) % count] - polygon[corner];
        const Vec3 area = b.cross(c);
        if (area.dot(before) < -tiny * tiny) return -std::numeric_limits<double>::infinity();
        smallest = std::min(smallest, normal.dot(area));
        if (area.norm() > tiny) before = area;
    }
    return smallest;
}

}  // namespace

int fan_corner(const std::vector<Vec3>& polygon) {
    Vec3 normal = Vec3::Zero();
    double extent = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec3 b = polygon[k] - polygon[0];
        const Vec3 c = polygon[k + 1] - polygon[0];
        normal += b.cross(c);
        extent = std::max({extent, b.squaredNorm(), c.squaredNorm()});
    }
    const double area = normal.norm();
    if (!(area > 1e-14 * extent)) return -1;
    normal /= area;
    const double tiny = 1e-12 * area;
    double best = thinnest(polygon, 0, normal, tiny);
    int corner = 0;
    const std::size_t searched = polygon.size() <= 100 ? polygon.size() : 1;
    for (std::size_t c = 1; c < searched && best <= tiny; ++c)
        if (const double smallest = thinnest(polygon, c, normal, tiny); smallest > best) {
            best = smallest;
            corner = static_cast<int>(c);
        }
    return best >= -tiny ? corner : -1;
}

}  // namespace ripstop
