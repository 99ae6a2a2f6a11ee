#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "borders.h"
#include "ripstop/base/error.h"

namespace ripstop::cad {
namespace {

constexpr double edges_across_a_face = 12;
constexpr double most_triangles = 1e7;
constexpr double least_ratio = 1.0 / 40;  // of the longest; the tip of a cone has infinite curvature

/// The area-weighted median size of a face: half of the area lies in smaller ones, so fillets and screws hardly
/// count.
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
    // An edge of length h on a circle of curvature k turns by h k, with an error of k h² / 8. A triangle on a
    // sphere has an error of k h² / 6 in its middle, and some edges become an eighth longer than asked for.
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

namespace {

/// A face has at least as many triangles as its border has pieces; half of all triangles are reserved for the
/// inside.
constexpr double most_pieces = most_of_all / 4;
constexpr int halvings = 40;
constexpr double crowded = 1.25;  // ratio of the triangles made to equilateral ones of these sizes
constexpr double beside = 5;      // and their number beside each piece of a border

/// The limit of triangles per face that keeps the total within its limit. `least` is the minimum of each face.
double share_of_face(const std::vector<double>& counts, const std::vector<double>& least) {
    const auto all = [&](double share) {
        double sum = 0;
        for (std::size_t f = 0; f < counts.size(); ++f) sum += std::max(least[f], std::min(counts[f], share));
        return sum;
    };
    if (all(most_of_face) <= most_of_all) return most_of_face;
    double low = 0, high = most_of_face;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (all(middle) <= most_of_all ? low : high) = middle;
    }
    return low;
}

}  // namespace

Bounded bound(const std::vector<TopoDS_Face>& faces, const MeshingOptions& asked, EdgeSizes& sizes) {
    sizes.finer.assign(faces.size(), 1);
    std::vector<double> counts;
    std::vector<std::optional<FaceSizes>> face_sizes;
    for (const TopoDS_Face& face : faces) {
        if (face.IsNull())
            face_sizes.emplace_back();
        else
            face_sizes.emplace_back(FaceSizes(face, sizes, 1));
        counts.push_back(face.IsNull() ? 0 : face_sizes.back()->triangles());
    }
    Bounded result;
    if (asked.chord_error || asked.edge_length) {
        result.triangles = std::accumulate(counts.begin(), counts.end(), 0.0);
        if (result.triangles > most_triangles)
            throw InputError("so fine a mesh would have " + std::to_string(std::lround(result.triangles / 1e6)) +
                             " million triangles, the limit is 10 million; give a larger --chord or --edge");
        return result;
    }
    const double pieces = Borders(faces, face_sizes, sizes).pieces();
    if (pieces > most_pieces) sizes.border = result.border = pieces / most_pieces;
    const Borders borders(faces, face_sizes, sizes);
    std::vector<double> least;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        least.push_back(faces[f].IsNull() ? 0 : borders.pieces(faces[f]));
        counts[f] = crowded * counts[f] + beside * least[f];
    }
    const double share = share_of_face(counts, least);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        sizes.most.push_back(std::max(least[f], std::min(counts[f], share)));
        result.triangles += sizes.most.back();
        if (counts[f] <= share) continue;
        sizes.finer[f] = std::sqrt(counts[f] / share);
        result.longer = std::max(result.longer, sizes.finer[f]);
        ++result.faces;
    }
    return result;
}

}  // namespace ripstop::cad
