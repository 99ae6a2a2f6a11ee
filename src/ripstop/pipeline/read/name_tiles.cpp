#include "ripstop/pipeline/read/name_tiles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr double reach_of_size = 0.1;  // relative to the surface's diagonal: tolerance for a point read off a drawing
constexpr double same_of_size = 1e-9;  // relative to the surface's diagonal: two surfaces share the point
constexpr double infinite = std::numeric_limits<double>::infinity();

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double length = along.squaredNorm();
    const double at = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
    return (a + at * along - p).norm();
}

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const bool above = normal.squaredNorm() > 0 && normal.dot((b - a).cross(p - a)) >= 0 &&
                       normal.dot((c - b).cross(p - b)) >= 0 && normal.dot((a - c).cross(p - c)) >= 0;
    if (above) return std::abs(normal.normalized().dot(p - a));
    return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

double distance(const TriangleMesh& mesh, const Vec3& p) {
    double least = infinite;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        least = std::min(least, distance_to_triangle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)));
    return least;
}

std::string bracketed(const Vec3& p) {
    return "[" + format_shortest(p.x()) + ", " + format_shortest(p.y()) + ", " + format_shortest(p.z()) + "]";
}

std::size_t surface_at(const CadModel& model, const Vec3& point, const std::string& place) {
    std::size_t nearest = 0, second = 0;
    double least = infinite, next = infinite;
    for (std::size_t i = 0; i < model.surfaces.size(); ++i) {
        const TriangleMesh& mesh = model.surfaces[i].mesh;
        if (box_of(mesh).exteriorDistance(point) > next) continue;
        const double away = distance(mesh, point);
        if (away < least) {
            second = nearest;
            next = least;
            nearest = i;
            least = away;
        } else if (away < next) {
            second = i;
            next = away;
        }
    }
    const NamedMesh& found = model.surfaces[nearest];
    const double size = box_of(found.mesh).diagonal().norm();
    if (!(least <= reach_of_size * size))
        throw InputError(place + ": at " + bracketed(point) + " is " + format_shortest(least) +
                         " away from the nearest surface, " + shown(found.name) +
                         ", expected a point on a surface, in the file's own unit; correct it");
    if (next - least <= same_of_size * size)
        throw InputError(place + ": at " + bracketed(point) + " is as near to " + shown(found.name) + " as to " +
                         shown(model.surfaces[second].name) + "; give a point inside one of them");
    return nearest;
}

std::size_t surface_called(const CadModel& model, const std::string& source, const std::string& place) {
    const auto is_called = [&](const auto& object) { return object.name == source; };
    const auto first = std::find_if(model.surfaces.begin(), model.surfaces.end(), is_called);
    if (first == model.surfaces.end()) {
        const auto unread = std::find_if(model.unread.begin(), model.unread.end(), is_called);
        throw InputError(place + ": no surface of the file is called " + shown(source) +
                         (unread == model.unread.end() ? ", expected a name exactly as in the file; correct it"
                                                       : ", only an object that cannot be read: " + unread->reason));
    }
    if (std::any_of(first + 1, model.surfaces.end(), is_called))
        throw InputError(place + ": several surfaces of the file are called " + shown(source) +
                         "; select one by a point on it: \"at\": [x, y, z]");
    return static_cast<std::size_t>(first - model.surfaces.begin());
}

}  // namespace

void name_tiles(CadModel& model, const Project& project) {
    if (model.surfaces.empty()) return;
    std::vector<const ProjectTile*> meant(model.surfaces.size(), nullptr);
    for (const ProjectTile& entry : project.tiles) {
        if (!entry.names_a_surface()) continue;
        const std::string place = project.file + ": tile " + shown(entry.name);
        const std::size_t i =
            entry.source ? surface_called(model, *entry.source, place) : surface_at(model, *entry.at, place);
        if (meant[i])
            throw InputError(place + ": the surface " + shown(model.surfaces[i].name) + " is called " +
                             shown(meant[i]->name) + " by another entry; remove one");
        meant[i] = &entry;
    }
    for (std::size_t i = 0; i < meant.size(); ++i)
        if (meant[i]) model.surfaces[i].name = meant[i]->name;
    for (std::size_t i = 0; i < meant.size(); ++i)
        for (std::size_t k = 0; meant[i] && k < meant.size(); ++k)
            if (k != i && model.surfaces[k].name == meant[i]->name)
                throw InputError(project.file + ": tile " + shown(meant[i]->name) +
                                 ": another surface of the file has the same name; rename one of them");
}

}  // namespace ripstop
