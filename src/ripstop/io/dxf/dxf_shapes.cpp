#include "ripstop/io/dxf/dxf_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "ripstop/base/text/units.h"

namespace ripstop {
namespace {

constexpr int spline_frame = 16;  // flag of a VERTEX that is a control point and not on the line

Vec3 dxf_normal(const DxfEntity& entity) {
    const Vec3 normal(entity.number(210), entity.number(220), entity.number(230, 1));
    return normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3::UnitZ();
}

struct Corner {
    Vec3 at;
    double bulge = 0;  // tan(angle / 4) of the arc to the next vertex
};

/// The number of chords for an arc: at least one per degree.
int chords(double radius, double sweep, double chord_error) {
    constexpr double most = 100000;
    const double share = 1 - chord_error / std::max(radius, chord_error);
    const double step = std::min(degree, 2 * std::acos(share));
    return std::max(1, static_cast<int>(std::ceil(std::min(most, std::abs(sweep) / step) - 1e-9)));
}

void add_arc(std::vector<Vec3>& points, const Vec3& centre, double radius, double start, double sweep,
             double chord_error) {
    const int steps = chords(radius, sweep, chord_error);
    for (int i = 0; i <= steps; ++i) {
        const double angle = start + sweep * i / steps;
        points.push_back(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0));
    }
}

/// Appends the points strictly between two corners; the corners themselves stay exact.
void add_bulge(std::vector<Vec3>& points, const Vec3& from, const Vec3& to, double bulge, double chord_error) {
    const Vec3 chord = to - from;
    const double sweep = 4 * std::atan(bulge), half = chord.head<2>().norm() / 2;
    if (half == 0 || std::abs(sweep) < 1e-9) return;
    const Vec3 left = Vec3(-chord.y(), chord.x(), 0) / (2 * half);
    const Vec3 centre = from + chord / 2 + half * (1 - bulge * bulge) / (2 * bulge) * left;
    const Vec3 arm = from - centre;
    const double start = std::atan2(arm.y(), arm.x());
    std::vector<Vec3> arc;
    add_arc(arc, centre, arm.head<2>().norm(), start, sweep, chord_error);
    points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
}

DxfShape through(const std::vector<Corner>& corners, bool is_closed, double chord_error) {
    DxfShape shape{{}, is_closed};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        shape.points.push_back(corners[i].at);
        const bool has_next = is_closed || i + 1 < corners.size();
        if (corners[i].bulge != 0 && has_next)
            add_bulge(shape.points, corners[i].at, corners[(i + 1) % corners.size()].at, corners[i].bulge, chord_error);
    }
    return shape;
}

DxfShape light_polyline(const DxfEntity& entity, double chord_error) {
    const double elevation = entity.number(38);
    std::vector<Corner> corners;
    for (const DxfTag& tag : entity.tags().subspan(1)) {
        if (tag.code == 10) corners.push_back({Vec3(entity.number(tag), 0, elevation), 0});
        if (tag.code == 20 && !corners.empty()) corners.back().at.y() = entity.number(tag);
        if (tag.code == 42 && !corners.empty()) corners.back().bulge = entity.number(tag);
    }
    return through(corners, (entity.flags() & 1) != 0, chord_error);
}

constexpr double full_turn = 2 * std::numbers::pi;

DxfShape circle(const DxfEntity& entity, double chord_error) {
    DxfShape shape{{}, true};
    add_arc(shape.points, entity.place(10), entity.number(40), 0, full_turn, chord_error);
    shape.points.pop_back();
    return shape;
}

DxfShape arc(const DxfEntity& entity, double chord_error) {
    const double start = std::fmod(entity.number(50), 360) * degree;
    double sweep = std::fmod(entity.number(51) * degree - start, full_turn);
    if (sweep <= 0) sweep += full_turn;
    DxfShape shape;
    add_arc(shape.points, entity.place(10), entity.number(40), start, sweep, chord_error);
    return shape;
}

/// An ellipse. Its axes are given in space. Its parameter is an angle only for a circle.
DxfShape ellipse(const DxfEntity& entity, double chord_error) {
    const Vec3 centre = entity.place(10), major = entity.place(11);
    const Vec3 minor = entity.number(40, 1) * dxf_normal(entity).cross(major);
    const double start = entity.number(41);
    double sweep = entity.number(42, full_turn) - start;
    if (std::abs(sweep) > full_turn) sweep = std::fmod(sweep, full_turn);
    if (sweep <= 0) sweep += full_turn;
    const bool is_closed = sweep > full_turn - 1e-9;
    const int steps = chords(std::max(major.norm(), minor.norm()), sweep, chord_error);
    DxfShape shape{{}, is_closed};
    for (int i = 0; i < steps + (is_closed ? 0 : 1); ++i) {
        const double t = start + sweep * i / steps;
        shape.points.push_back(centre + std::cos(t) * major + std::sin(t) * minor);
    }
    return shape;
}

}  // namespace

Eigen::Matrix3d dxf_plane(const DxfEntity& entity) {
    static const std::set<std::string_view> in_space{"LINE", "POINT", "SPLINE", "HELIX", "ELLIPSE", "MTEXT"};
    constexpr int in_3d = 8;
    const bool is_in_space =
        in_space.contains(entity.type()) || (entity.type() == "POLYLINE" && (entity.flags() & in_3d) != 0);
    if (is_in_space) return Eigen::Matrix3d::Identity();
    const Vec3 z = dxf_normal(entity);
    constexpr double near = 1.0 / 64;
    const bool is_near_z = std::abs(z.x()) < near && std::abs(z.y()) < near;
    const Vec3 x = (is_near_z ? Vec3::UnitY() : Vec3::UnitZ()).cross(z).normalized();
    Eigen::Matrix3d axes;
    axes << x, z.cross(x), z;
    return axes;
}

DxfShape dxf_shape(const DxfEntity& entity, double chord_error) {
    if (entity.type() == "LINE") return {{entity.place(10), entity.place(11)}, false};
    if (entity.type() == "LWPOLYLINE") return light_polyline(entity, chord_error);
    if (entity.type() == "CIRCLE") return circle(entity, chord_error);
    return entity.type() == "ARC" ? arc(entity, chord_error) : ellipse(entity, chord_error);
}

DxfShape dxf_polyline(const DxfEntity& head, DxfTagSpan tags, std::size_t& next, const std::string& name,
                      double chord_error) {
    const bool is_in_3d = (head.flags() & 8) != 0;
    const double elevation = head.number(30);
    std::vector<Corner> corners;
    while (next < tags.size()) {
        const DxfEntity part = first_entity(tags.subspan(next), name);
        if (part.type() != "VERTEX" && part.type() != "SEQEND") break;
        next += part.tags().size();
        if (part.type() == "SEQEND") break;
        if ((part.flags() & spline_frame) != 0) continue;
        Vec3 at = part.place(10);
        if (!is_in_3d) at.z() = elevation;
        corners.push_back({at, is_in_3d ? 0 : part.number(42)});
    }
    return through(corners, (head.flags() & 1) != 0, chord_error);
}

}  // namespace ripstop
