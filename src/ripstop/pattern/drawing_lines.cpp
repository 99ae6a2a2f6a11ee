#include "ripstop/pattern/drawing_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "ripstop/base/number_text.h"
#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

constexpr double same_place = 0.01 * millimetre;
constexpr double slit_reach = 0.05 * millimetre;  // of a notch that is drawn from the contour

/// Lines drawn over each other have the same box and the same length.
using Key = std::tuple<std::string, double, double, double, double, double>;

Key key_of(const DrawingSurvey& survey, const DrawnPath& path) {
    const auto step = [&](double number) { return std::round(number * survey.metres_per_unit / same_place); };
    const Vec2 lower = path.points.colwise().minCoeff(), upper = path.points.colwise().maxCoeff();
    return {path.layer,      step(lower.x()), step(lower.y()),
            step(upper.x()), step(upper.y()), step(line_length({path.points, {}, path.is_closed}))};
}

/// A rising and a falling diagonal have the same box: one point tells.
bool meet(const DrawnPath& a, const DrawnPath& b, double tolerance) {
    const Vec2 start = a.points.row(0);
    return (b.points.rowwise() - start.transpose()).rowwise().norm().minCoeff() <= tolerance;
}

double box_size(const Points2& points) {
    return Vec2(points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

/// How far an end is from where it could go on: the nearest other end of an open line of the layer.
struct Gap {
    double width = -1;
    Vec2 from, to;
};

Gap nearest_gap(const std::vector<const JoinedLine*>& open, const JoinedLine& line) {
    const auto first = [](const JoinedLine& l) { return Vec2(l.points.row(0)); };
    const auto last = [](const JoinedLine& l) { return Vec2(l.points.row(l.points.rows() - 1)); };
    Gap gap{(last(line) - first(line)).norm(), last(line), first(line)};
    constexpr std::size_t most = 500;  // of more the own ends tell enough
    for (const JoinedLine* other : open)
        for (const Vec2& here : {first(line), last(line)})
            for (const Vec2& there : {first(*other), last(*other)})
                if (other != &line && open.size() <= most && (there - here).norm() < gap.width)
                    gap = {(there - here).norm(), here, there};
    return gap;
}

bool is_slit(const JoinedLine& line, const std::vector<const JoinedLine*>& closed) {
    for (const JoinedLine* contour : closed)
        for (const Eigen::Index end : {Eigen::Index{0}, line.points.rows() - 1})
            if (distance_to_outline(contour->points, line.points.row(end)) <= slit_reach) return true;
    return false;
}

class ContourFinder {
  public:
    ContourFinder(DrawingSurvey& survey, const LayerLines& layer)
        : survey_(survey), layer_(layer), use_(use_of(survey.convention, layer.layer)) {
        for (const JoinedLine& line : layer.lines) (line.is_closed ? closed_ : open_).push_back(&line);
    }

    void add_to(std::vector<FoundContour>& contours) {
        const bool is_known = survey_.convention != LayerConvention::unknown;
        const bool counts = use_ == LayerUse::cut || use_ == LayerUse::sew || (!is_known && use_ == LayerUse::other);
        if (!counts) return;
        for (const JoinedLine* line : closed_) contours.push_back(contour_of(*line));
        for (const JoinedLine* line : open_) report_open(*line, is_known);
    }

  private:
    FoundContour contour_of(const JoinedLine& line) {
        FoundContour found{{}, layer_.group, use_, line.points};
        DrawingContour& facts = found.facts;
        facts.piece = piece_name(survey_, layer_.group, line.points);
        facts.layer = layer_.layer;
        facts.lower = line.points.colwise().minCoeff();
        facts.upper = line.points.colwise().maxCoeff();
        facts.area = std::abs(signed_area(line.points));
        facts.perimeter = line_length(line);
        facts.parts = static_cast<int>(line.lines.size());
        facts.is_cut = use_ != LayerUse::sew;
        const SelfIntersections crossings = self_intersections(line.points);
        if (crossings.count > 0)
            issue("crossing", crossings.first,
                  fmt::format("{}: the contour on layer {} crosses or touches itself at {}{}", facts.piece,
                              layer_.layer, place_text(crossings.first),
                              crossings.count > 1 ? fmt::format(" and {} other places", crossings.count - 1) : ""));
        return found;
    }

    void report_open(const JoinedLine& line, bool is_known) {
        if (is_slit(line, closed_)) return;
        const double length = line_length(line);
        const Gap gap = nearest_gap(open_, line);
        const bool is_near = gap.width < (is_known ? 0.2 : 0.01) * length;
        if (!is_near && !is_known) return;
        const std::string piece = piece_name(survey_, layer_.group, line.points);
        if (is_near)
            issue("gap", gap.from,
                  fmt::format("{}: the contour on layer {} is open by {} mm between {} and {}; join its ends", piece,
                              layer_.layer, format_fixed(gap.width / millimetre, 3), place_text(gap.from),
                              place_text(gap.to)));
        else
            issue("open", gap.from,
                  fmt::format("{}: a line of {} mm on layer {} is no closed contour, it ends at {}; close it or put it "
                              "on a layer for lines that are not cut",
                              piece, format_fixed(length / millimetre, 1), layer_.layer, place_text(gap.from)));
    }

    void issue(const char* code, const Vec2& at, const std::string& message) {
        survey_.check.issues.push_back({code, message, true, at});
    }

    DrawingSurvey& survey_;
    const LayerLines& layer_;
    LayerUse use_;
    std::vector<const JoinedLine*> closed_, open_;
};

}  // namespace

std::string place_text(const Vec2& metres) {
    return fmt::format("({}, {}) mm", format_fixed(metres.x() / millimetre, 2),
                       format_fixed(metres.y() / millimetre, 2));
}

std::vector<const DrawnPath*> sound_lines(DrawingSurvey& survey) {
    struct Fault {
        int count = 0;
        Vec2 first;
    };
    std::map<std::string, Fault> without_length, twice;
    std::map<Key, std::vector<const DrawnPath*>> seen;
    std::vector<const DrawnPath*> sound;
    const double tolerance = same_place / survey.metres_per_unit;
    const auto count = [&](std::map<std::string, Fault>& faults, const DrawnPath& path) {
        Fault& fault = faults[path.layer];
        if (fault.count++ == 0) fault.first = Vec2(path.points.row(0)) * survey.metres_per_unit;
    };
    for (const DrawnPath& path : survey.drawing.paths) {
        if (box_size(path.points) <= 0) {
            count(without_length, path);
            continue;
        }
        std::vector<const DrawnPath*>& alike = seen[key_of(survey, path)];
        const bool is_twin = !alike.empty() && meet(path, *alike.front(), tolerance);
        if (is_twin && use_of(survey.convention, path.layer) != LayerUse::data)
            count(twice, path);
        else
            sound.push_back(&path);
        if (alike.empty()) alike.push_back(&path);
    }
    for (const auto& [layer, fault] : without_length)
        survey.check.issues.push_back({"zero_length",
                                       fmt::format("layer {}: {} without length, the first at {}; delete {}", layer,
                                                   fault.count == 1 ? "a line" : fmt::format("{} lines", fault.count),
                                                   place_text(fault.first), fault.count == 1 ? "it" : "them"),
                                       true, fault.first});
    for (const auto& [layer, fault] : twice)
        survey.check.issues.push_back(
            {"duplicate",
             fmt::format("layer {}: {} twice in the same place, the first at {}; it would be cut twice", layer,
                         fault.count == 1 ? "a line is drawn" : fmt::format("{} lines are drawn", fault.count),
                         place_text(fault.first)),
             true, fault.first});
    return sound;
}

std::vector<FoundContour> find_contours(DrawingSurvey& survey, const std::vector<LayerLines>& layers) {
    std::vector<FoundContour> contours;
    for (const LayerLines& layer : layers) ContourFinder(survey, layer).add_to(contours);
    return contours;
}

}  // namespace ripstop
