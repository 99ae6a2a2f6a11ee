#include "ripstop/pattern/drawing/drawing_openings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/pattern/cut/allowance_fit.h"

namespace ripstop {
namespace {

constexpr double on_the_line = 0.1 * millimetre;  // cutters are not more precise
constexpr double usual_share = 0.9;
constexpr double most_places = 400;
constexpr double sparsest = 0.01;  // least distance between places on the sew line [m]

/// A place on the sew line: the distance straight outward to the next cut, the largest empty ball outside that
/// touches the place, and what limits that ball.
struct Outside {
    SewPlace place;
    double cut = std::numeric_limits<double>::infinity(), radius = std::numeric_limits<double>::infinity();  ///< [m]
    SewPlace met = {};
    double width = 0;  ///< from place to place [m]
};

AllowedEdge closed_edge(const Points2& line, double allowance) {
    const bool is_clockwise = signed_area(line) < 0;
    Points2 closed(line.rows() + 1, 2);
    closed.topRows(line.rows()) = is_clockwise ? Points2(line.colwise().reverse()) : line;
    closed.row(line.rows()) = closed.row(0);
    return {closed, allowance};
}

double way_to_cut(const Vec2& from, const Vec2& way, const std::vector<const Points2*>& cut_lines) {
    double least = std::numeric_limits<double>::infinity();
    for (const Points2* line : cut_lines)
        least = std::min(least, distance_along(*line, from - on_the_line * way, way) - on_the_line);
    return least;
}

Outside outside_of(const SewContour& contour, const SewPlace& place, const std::vector<const Points2*>& cut_lines) {
    const SewSegment& segment = contour.segments()[place.segment];
    const Vec2 at = segment.at(place.along);
    Outside found{place, way_to_cut(at, segment.outward, cut_lines)};
    for (std::size_t i = 0; i < contour.segments().size(); ++i) {
        const SewSegment& other = contour.segments()[i];
        const BallContact contact =
            ball_contact(at - on_the_line * segment.outward, segment.outward, other, {0, other.length});
        if (i == place.segment || !(contact.reach < found.radius)) continue;
        found.radius = contact.reach;
        found.met = {i, (contact.at - other.from).dot(other.way)};
        found.width = (contact.at - at).norm();
    }
    return found;
}

std::vector<Outside> look_outside(const SewContour& contour, const std::vector<const Points2*>& cut_lines) {
    std::vector<Outside> found;
    const double spacing = std::max(sparsest, contour.length() / most_places);
    for (std::size_t i = 0; i < contour.segments().size(); ++i) {
        const double length = contour.segments()[i].length;
        const int count = std::max(1, static_cast<int>(length / spacing));
        for (int k = 0; k < count; ++k)
            found.push_back(outside_of(contour, {i, length * (k + 0.5) / count}, cut_lines));
    }
    return found;
}

/// The allowance of the drawing: nine in ten of the places whose ball contains a cut have at most this distance to
/// it.
double usual_allowance(const std::vector<Outside>& all) {
    std::vector<double> cut;
    for (const Outside& outside : all)
        if (outside.cut < outside.radius) cut.push_back(std::max(0.0, outside.cut));
    if (cut.empty()) return 0;
    const auto at = cut.begin() + static_cast<std::ptrdiff_t>(usual_share * static_cast<double>(cut.size() - 1));
    std::nth_element(cut.begin(), at, cut.end());
    return *at;
}

}  // namespace

std::optional<LostOpening> find_lost_opening(const Points2& sew_line, const std::vector<const Points2*>& cut_lines) {
    const std::vector<Outside> all = look_outside(SewContour({closed_edge(sew_line, 0)}), cut_lines);
    const SewContour contour({closed_edge(sew_line, usual_allowance(all))});
    std::optional<LostOpening> largest;
    for (const Outside& outside : all) {
        if (!std::isfinite(outside.radius) || outside.cut < outside.radius) continue;
        if (!contour.is_apart(outside.place, outside.met)) continue;
        const SewSegment& segment = contour.segments()[outside.place.segment];
        const Vec2 at = segment.at(outside.place.along), middle = at + outside.radius * segment.outward;
        const SewSegment& other = contour.segments()[outside.met.segment];
        const Vec2 met = other.at(outside.met.along);
        if (way_to_cut(met, (middle - met).normalized(), cut_lines) < outside.radius) continue;
        const double length = contour.pocket(outside.place, outside.met).length;
        if (!largest || length > largest->length) largest = LostOpening{at, length, outside.width};
    }
    return largest;
}

}  // namespace ripstop
