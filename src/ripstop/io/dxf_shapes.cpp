#include "ripstop/io/dxf_shapes.h"

#include <cmath>
#include <numbers>

#include "ripstop/base/units.h"

namespace ripstop {
namespace {

constexpr int spline_frame = 16;  // a VERTEX that is not on the line

struct Corner {
    Vec2 at;
    double bulge = 0;  // tangent of a quarter of the angle of the arc to the next one
};

void add_arc(std::vector<Vec2>& points, const Vec2& centre, double radius, double start, double sweep) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / degree - 1e-9)));
    for (int i = 0; i <= steps; ++i) {
        const double angle = start + sweep * i / steps;
        points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
}

/// The points strictly between two corners; both ends are exact.
void add_bulge(std::vector<Vec2>& points, const Vec2& from, const Vec2& to, double bulge) {
    const Vec2 chord = to - from;
    const double sweep = 4 * std::atan(bulge), half = chord.norm() / 2;
    if (half == 0 || std::abs(sweep) < 1e-9) return;
    const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
    const Vec2 centre = from + chord / 2 + half * (1 - bulge * bulge) / (2 * bulge) * left;
    const Vec2 arm = from - centre;
    const double start = std::atan2(arm.y(), arm.x());
    std::vector<Vec2> arc;
    add_arc(arc, centre, arm.norm(), start, sweep);
    points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
}

DxfShape through(const std::vector<Corner>& corners, bool is_closed) {
    DxfShape shape{{}, is_closed};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        shape.points.push_back(corners[i].at);
        const bool has_next = is_closed || i + 1 < corners.size();
        if (corners[i].bulge != 0 && has_next)
            add_bulge(shape.points, corners[i].at, corners[(i + 1) % corners.size()].at, corners[i].bulge);
    }
    return shape;
}

DxfShape light_polyline(const DxfEntity& entity) {
    std::vector<Corner> corners;
    for (const DxfTag& tag : entity.tags().subspan(1)) {
        if (tag.code == 10) corners.push_back({Vec2(entity.number(tag), 0), 0});
        if (tag.code == 20 && !corners.empty()) corners.back().at.y() = entity.number(tag);
        if (tag.code == 42 && !corners.empty()) corners.back().bulge = entity.number(tag);
    }
    return through(corners, (entity.flags() & 1) != 0);
}

DxfShape circular(const DxfEntity& entity) {
    constexpr double whole = 2 * std::numbers::pi;
    DxfShape shape;
    const Vec2 centre = entity.point(10);
    const double radius = entity.number(40);
    if (entity.type() == "CIRCLE") {
        add_arc(shape.points, centre, radius, 0, whole);
        shape.points.pop_back();
        shape.is_closed = true;
        return shape;
    }
    const double start = std::fmod(entity.number(50), 360) * degree;
    double sweep = std::fmod(entity.number(51) * degree - start, whole);
    if (sweep <= 0) sweep += whole;
    add_arc(shape.points, centre, radius, start, sweep);
    return shape;
}

}  // namespace

DxfShape dxf_shape(const DxfEntity& entity) {
    if (entity.type() == "LINE") return {{entity.point(10), entity.point(11)}, false};
    if (entity.type() == "LWPOLYLINE") return light_polyline(entity);
    return circular(entity);
}

DxfShape dxf_polyline(const DxfEntity& head, DxfTagSpan tags, std::size_t& next, const std::string& name) {
    std::vector<Corner> corners;
    while (next < tags.size()) {
        const DxfEntity part = first_entity(tags.subspan(next), name);
        if (part.type() != "VERTEX" && part.type() != "SEQEND") break;
        next += part.tags().size();
        if (part.type() == "SEQEND") break;
        if ((part.flags() & spline_frame) == 0) corners.push_back({part.point(10), part.number(42)});
    }
    return through(corners, (head.flags() & 1) != 0);
}

}  // namespace ripstop
