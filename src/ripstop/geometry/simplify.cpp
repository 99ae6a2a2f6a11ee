#include "ripstop/geometry/simplify.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ripstop {
namespace {

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 way = b - a;
    const double length2 = way.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - a).dot(way) / length2, 0.0, 1.0) : 0;
    return (a + t * way - p).norm();
}

}  // namespace

Points2 simplified(const Points2& line, double tolerance) {
    const Eigen::Index count = line.rows();
    if (count < 3) return line;
    std::vector<bool> kept(static_cast<std::size_t>(count), false);
    kept.front() = kept.back() = true;
    std::vector<std::pair<Eigen::Index, Eigen::Index>> open{{0, count - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        double furthest = tolerance;
        Eigen::Index at = -1;
        for (Eigen::Index i = first + 1; i < last; ++i)
            if (const double away = distance_to_segment(line.row(i), line.row(first), line.row(last));
                away > furthest) {
                furthest = away;
                at = i;
            }
        if (at < 0) continue;
        kept[static_cast<std::size_t>(at)] = true;
        open.emplace_back(first, at);
        open.emplace_back(at, last);
    }
    Points2 result(std::count(kept.begin(), kept.end(), true), 2);
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < count; ++i)
        if (kept[static_cast<std::size_t>(i)]) result.row(row++) = line.row(i);
    return result;
}

}  // namespace ripstop
