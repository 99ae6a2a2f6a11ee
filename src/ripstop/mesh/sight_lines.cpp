#include "ripstop/mesh/sight_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

constexpr int leaf = 4;  // triangles in a leaf

Vec3 middle(const std::array<Vec3, 3>& triangle) {
    return (triangle[0] + triangle[1] + triangle[2]) / 3;
}

bool meets(const Eigen::AlignedBox3d& box, const Vec3& from, const Vec3& inverse) {
    double near = 0, far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        double low = (box.min()[axis] - from[axis]) * inverse[axis],
               high = (box.max()[axis] - from[axis]) * inverse[axis];
        if (std::isnan(low) || std::isnan(high)) continue;  // the line runs within a face of the box
        if (low > high) std::swap(low, high);
        near = std::max(near, low);
        far = std::min(far, high);
    }
    return near <= far;
}

/// The distance along the line to the triangle; infinity if they do not meet. Moeller and Trumbore (1997).
double distance(const std::array<Vec3, 3>& triangle, const Vec3& from, const Vec3& direction) {
    const double none = std::numeric_limits<double>::infinity();
    const Vec3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0], p = direction.cross(v);
    const double det = u.dot(p);
    if (det == 0) return none;
    const Vec3 away = from - triangle[0], q = away.cross(u);
    const double b = away.dot(p) / det, c = direction.dot(q) / det;
    return b < 0 || c < 0 || b + c > 1 ? none : v.dot(q) / det;
}

}  // namespace

SightLines::SightLines(const std::vector<const TriangleMesh*>& meshes) {
    for (const TriangleMesh* mesh : meshes)
        for (int t = 0; t < mesh->triangle_count(); ++t)
            triangles_.push_back({mesh->corner(t, 0), mesh->corner(t, 1), mesh->corner(t, 2)});
    if (!triangles_.empty()) build(0, static_cast<int>(triangles_.size()));
}

int SightLines::build(int first, int count) {
    const auto begin = triangles_.begin() + first, end = begin + count;
    const int number = static_cast<int>(boxes_.size());
    Eigen::AlignedBox3d box, middles;
    for (auto triangle = begin; triangle != end; ++triangle) {
        for (const Vec3& corner : *triangle) box.extend(corner);
        middles.extend(middle(*triangle));
    }
    boxes_.push_back({box, first, count, 0});
    if (count <= leaf) return number;
    int axis = 0;
    middles.sizes().maxCoeff(&axis);
    const int half = count / 2;
    std::nth_element(begin, begin + half, end,
                     [axis](const auto& p, const auto& q) { return middle(p)[axis] < middle(q)[axis]; });
    build(first, half);
    const int second = build(first + half, count - half);
    boxes_[at(number)].count = 0;
    boxes_[at(number)].second = second;
    return number;
}

bool SightLines::is_blocked(const Vec3& from, const Vec3& direction, double least) const {
    if (boxes_.empty()) return false;
    const Vec3 inverse = direction.cwiseInverse();
    std::vector<int> open{0};
    while (!open.empty()) {
        const int number = open.back();
        open.pop_back();
        const Box& box = boxes_[at(number)];
        if (!meets(box.box, from, inverse)) continue;
        if (box.count == 0) {
            open.push_back(number + 1);
            open.push_back(box.second);
            continue;
        }
        for (int t = box.first; t < box.first + box.count; ++t) {
            const double away = distance(triangles_[at(t)], from, direction);
            if (away > least && away < std::numeric_limits<double>::infinity()) return true;
        }
    }
    return false;
}

}  // namespace ripstop
