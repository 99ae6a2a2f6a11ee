#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "meshing.h"

namespace ripstop::cad {
namespace {

constexpr double edges_across_a_face = 12;
constexpr double least_ratio = 1.0 / 40;  // of the longest: the tip of a cone is bent without end

/// The size of faces that half of the area lies in smaller ones than: fillets and screws do not count for much.
double middle_size(std::vector<double> areas) {
    std::sort(areas.begin(), areas.end());
    const double half = std::accumulate(areas.begin(), areas.end(), 0.0) / 2;
    double sum = 0;
    for (const double area : areas)
        if ((sum += area) >= half) return std::sqrt(area);
    return 1;
}

}  // namespace

double EdgeSizes::at(double curvature) const {
    if (!(curvature > 0) || !std::isfinite(curvature)) return longest;
    // An edge of length h on a circle of curvature k turns by h k and lies k h² / 8 off it. A triangle on a sphere lies
    // k h² / 6 off it in its middle, and some edges come out an eighth longer than asked for.
    const double by_turn = turn / curvature, by_chord = std::sqrt(4.7 * chord_error / curvature);
    return std::clamp(std::min(by_turn, by_chord), shortest, longest);
}

double finest(const EdgeSizes& sizes) {
    return sizes.finer.empty() ? 1 : *std::min_element(sizes.finer.begin(), sizes.finer.end());
}

EdgeSizes edge_sizes(const std::vector<TopoDS_Face>& faces, const MeshingOptions& asked) {
    const double infinite = std::numeric_limits<double>::infinity();
    EdgeSizes sizes;
    std::vector<double> areas;
    for (const TopoDS_Face& face : faces) {
        if (face.IsNull()) continue;
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face, properties);
        areas.push_back(std::abs(properties.Mass()));
    }
    sizes.longest =
        asked.edge_length ? *asked.edge_length / millimetre : middle_size(std::move(areas)) / edges_across_a_face;
    sizes.chord_error = asked.chord_error ? *asked.chord_error / millimetre : infinite;
    sizes.turn = asked.chord_error ? infinite : turn_of_accuracy;
    sizes.shortest = std::min(sizes.longest * least_ratio, asked.chord_error ? sizes.chord_error : infinite);
    return sizes;
}

}  // namespace ripstop::cad
