#include "ripstop/pipeline/read/grain_lines.h"

#include <algorithm>
#include <limits>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/mesh/surface_finder.h"

namespace ripstop {
namespace {

constexpr double reach_of_length = 1.0 / 50;  // of its length: a straight line over a bulging tile stands off it
constexpr double unreachable = std::numeric_limits<double>::infinity();

std::string upper(std::string text) {
    for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return text;
}

bool says_grain(const std::string& name, const std::vector<std::string>& layers) {
    return upper(name) == "GRAIN" || upper(name) == "WARP" ||
           std::any_of(layers.begin(), layers.end(), [&](const std::string& own) { return upper(own) == upper(name); });
}

/// The parts of a layer's path between `::`.
std::vector<std::string> parts(const std::string& path) {
    std::vector<std::string> found;
    std::size_t from = 0;
    for (std::size_t end = path.find("::"); end != std::string::npos; end = path.find("::", from)) {
        found.push_back(path.substr(from, end - from));
        from = end + 2;
    }
    found.push_back(path.substr(from));
    return found;
}

double length_of(const NamedCurve& curve) {
    double length = 0;
    for (Eigen::Index i = 1; i < curve.points.rows(); ++i)
        length += (curve.points.row(i) - curve.points.row(i - 1)).norm();
    return length;
}

/// The greatest distance from the points to a surface; infinite if a point is farther away than `reach`.
double distance(SurfaceFinder& surface, const std::vector<Vec3>& points, double reach) {
    double furthest = 0;
    for (const Vec3& point : points) {
        const auto found = surface.nearest(point, reach);
        if (!found) return unreachable;
        furthest = std::max(furthest, found->distance);
    }
    return furthest;
}

/// The points of the curve and the midpoints between them.
std::vector<Vec3> places_on(const NamedCurve& curve) {
    std::vector<Vec3> places = {Vec3(curve.points.row(0))};
    for (Eigen::Index i = 1; i < curve.points.rows(); ++i) {
        places.emplace_back((curve.points.row(i - 1) + curve.points.row(i)) / 2);
        places.emplace_back(curve.points.row(i));
    }
    return places;
}

std::string coordinates_text(const Vec3& v) {
    return format_fixed(v.x(), 3) + ", " + format_fixed(v.y(), 3) + ", " + format_fixed(v.z(), 3);
}

std::string text_of(const Vec3& v) {
    return format_shortest(v.x()) + ", " + format_shortest(v.y()) + ", " + format_shortest(v.z());
}

/// Parses three numbers separated by commas or blanks.
Vec3 direction_of(const std::string& text, const std::string& name) {
    std::vector<double> numbers;
    std::size_t from = text.find_first_not_of(", ;");
    while (from != std::string::npos) {
        const std::size_t end = std::min(text.find_first_of(", ;", from), text.size());
        const std::optional<double> number = parse_double(text.substr(from, end - from));
        if (!number) break;
        numbers.push_back(*number);
        from = text.find_first_not_of(", ;", end);
    }
    if (numbers.size() != 3 || from != std::string::npos || !(Vec3(numbers.data()).norm() > 0))
        throw InputError("tile " + name + ": its attribute warp is \"" + text +
                         "\", expected a direction of three numbers such as 0, 0, 1; correct it in the CAD");
    return Vec3(numbers.data());
}

}  // namespace

bool is_grain_line(const NamedCurve& curve, const std::vector<std::string>& layers) {
    if (says_grain(curve.name, layers)) return true;
    for (const char* key : {"layer", "group"}) {
        const auto path = curve.attributes.find(key);
        if (path == curve.attributes.end()) continue;
        std::vector<std::string> names = parts(path->second);
        names.push_back(path->second);
        const auto says = [&](const std::string& name) { return says_grain(name, layers); };
        if (std::any_of(names.begin(), names.end(), says)) return true;
    }
    return false;
}

std::vector<std::string> lay_grain_lines(CadModel& model, const std::vector<std::string>& layers) {
    std::vector<std::string> remarks;
    std::vector<SurfaceFinder> targets;
    for (const NamedMesh& surface : model.surfaces) targets.emplace_back(surface.mesh);
    std::vector<bool> has_line(targets.size(), false);
    for (const NamedCurve& curve : model.curves) {
        if (!is_grain_line(curve, layers)) continue;
        const std::string line = "grain line " + (curve.name.empty() ? "" : curve.name + " ") + "from (" +
                                 coordinates_text(curve.points.row(0)) + ") m";
        const Vec3 way = curve.points.row(curve.points.rows() - 1) - curve.points.row(0);
        if (!(way.norm() > 0)) {
            remarks.push_back(line + " left out: it ends where it starts; draw it from tail to head of the arrow");
            continue;
        }
        const std::vector<Vec3> places = places_on(curve);
        const double reach = reach_of_length * length_of(curve);
        std::size_t best = 0;
        double least = unreachable;
        for (std::size_t i = 0; i < targets.size(); ++i)
            if (const double away = distance(targets[i], places, std::min(reach, least)); away < least) {
                best = i;
                least = away;
            }
        if (!(least <= reach)) {
            remarks.push_back(line + " left out: it lies on no tile; draw it on the surface");
        } else if (has_line[best]) {
            remarks.push_back(line + " left out: tile " + model.surfaces[best].name +
                              " already has a grain line; keep one");
        } else {
            has_line[best] = true;
            model.surfaces[best].attributes["warp"] = text_of(way);
            model.surfaces[best].attributes["warp source"] = "grain line";
        }
    }
    return remarks;
}

void take_warp(const NamedMesh& surface, TileOptions& options) {
    if (const auto warp = surface.attributes.find("warp"); warp != surface.attributes.end()) {
        options.warp = direction_of(warp->second, surface.name);
        const auto source = surface.attributes.find("warp source");
        options.warp_source = source != surface.attributes.end() ? source->second : "attribute warp";
    } else if (surface.warp.rows() > 0) {
        options.warp_field = surface.warp;
        options.warp_source = "the file's warp of each triangle";
    }
}

}  // namespace ripstop
