#include "ripstop/pattern/drawing/drawing_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "ripstop/base/text/number_text.h"
#include "ripstop/geometry/polygon.h"

namespace ripstop {
namespace {

constexpr double drawn_precision = 0.01 * millimetre;
constexpr double slit_reach = 0.05 * millimetre;  // distance of a notch's slit from the contour it starts at

/// Lines drawn over each other have the same bounding box and length.
using Key = std::tuple<std::string, double, double, double, double, double>;

Key key_of(const DrawingSurvey& survey, const DrawnPath& path) {
    const auto step = [&](double number) { return std::round(number * survey.metres_per_unit / drawn_precision); };
    const Vec2 lower = path.points.colwise().minCoeff(), upper = path.points.colwise().maxCoeff();
    return {path.layer,      step(lower.x()), step(lower.y()),
            step(upper.x()), step(upper.y()), step(line_length({path.points, {}, path.is_closed}))};
}

/// Compares one more point, because a rising and a falling diagonal have the same box.
bool meet(const DrawnPath& a, const DrawnPath& b, double tolerance) {
    const Vec2 start = a.points.row(0);
    return (b.points.rowwise() - start.transpose()).rowwise().norm().minCoeff() <= tolerance;
}

double box_size(const Points2& points) {
    return Vec2(points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

/// The distance from an end of an open line to the nearest other end on its layer.
struct Gap {
    double width = -1;
    Vec2 from, to;
};

Gap nearest_gap(const std::vector<const JoinedLine*>& open, const JoinedLine& line) {
    const auto first = [](const JoinedLine& l) { return Vec2(l.points.row(0)); };
    const auto last = [](const JoinedLine& l) { return Vec2(l.points.row(l.points.rows() - 1)); };
    Gap gap{(last(line) - first(line)).norm(), last(line), first(line)};
    constexpr std::size_t most = 500;
    if (open.size() > most) return gap;  // the line's own ends suffice
    for (const JoinedLine* other : open)
        for (const Vec2& here : {first(line), last(line)})
            for (const Vec2& there : {first(*other), last(*other)})
                if (other != &line && (there - here).norm() < gap.width) gap = {(there - here).norm(), here, there};
    return gap;
}

/// A closed line and its box, widened by the reach of slits.
struct Ring {
    const JoinedLine* line;
    Vec2 lower, upper;
    explicit Ring(const JoinedLine& ring)
        : line(&ring),
          lower(Vec2(ring.points.colwise().minCoeff()) - Vec2::Constant(slit_reach)),
          upper(Vec2(ring.points.colwise().maxCoeff()) + Vec2::Constant(slit_reach)) {}
};

bool is_slit(const JoinedLine& line, const std::vector<Ring>& rings) {
    for (const Eigen::Index i : {Eigen::Index{0}, line.points.rows() - 1}) {
        const Vec2 end = line.points.row(i);
        for (const Ring& ring : rings) {
            const bool is_near = (end.array() >= ring.lower.array()).all() && (end.array() <= ring.upper.array()).all();
            if (is_near && distance_to_outline(ring.line->points, end) <= slit_reach) return true;
        }
    }
    return false;
}

class ContourFinder {
  public:
    ContourFinder(DrawingSurvey& survey, const LayerLines& layer)
        : survey_(survey), layer_(layer), use_(use_of(survey.convention, layer.layer)) {
        for (const JoinedLine& line : layer.lines) {
            if (line.is_closed)
                closed_.emplace_back(line);
            else
                open_.push_back(&line);
        }
    }

    void add_to(std::vector<FoundContour>& contours) {
        if (!counts()) return;
        for (const Ring& ring : closed_) contours.push_back(contour_of(*ring.line));
    }

    /// Reports the outlines that are open. `contours` holds those of all layers.
    void report_open(const std::vector<FoundContour>& contours) {
        if (!counts()) return;
        OpenLines marks;
        for (const JoinedLine* line : open_) {
            if (is_slit(*line, closed_)) continue;
            ++survey_.check.open_lines;
            const bool is_told = is_known() ? tell_open(*line) : tell_open_outline(*line, contours);
            if (!is_told) marks.add(*line);
        }
        if (marks.count == 0) return;
        const bool is_one = marks.count == 1;
        survey_.check.issues.push_back(
            {"open_line",
             fmt::format("layer {}: {} of {} mm{}, {}at {}, {} no piece; {} not checked", layer_.layer,
                         is_one ? "an open line" : fmt::format("{} open lines", marks.count),
                         format_fixed(marks.length / millimetre, 1), is_one ? "" : " in all",
                         is_one ? "" : "the first ", place_text(marks.first), is_one ? "bounds" : "bound",
                         is_one ? "it was" : "they were"),
             false, marks.first});
    }

  private:
    /// Lines that are not outlines.
    struct OpenLines {
        int count = 0;
        double length = 0;
        Vec2 first = Vec2::Zero();
        void add(const JoinedLine& line) {
            if (count++ == 0) first = line.points.row(0);
            length += line_length(line);
        }
    };

    bool is_known() const { return survey_.convention != LayerConvention::unknown; }
    bool counts() const {
        return use_ == LayerUse::cut || use_ == LayerUse::sew || (!is_known() && use_ == LayerUse::other);
    }

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
        check_plane(line, facts.piece);
        if (line.points.rows() < 3)
            issue("crossing", line.points.row(0),
                  fmt::format("{}: the contour on layer {} runs from {} and back and encloses nothing; delete it",
                              facts.piece, layer_.layer, place_text(line.points.row(0))));
        const SelfIntersections crossings = self_intersections(line.points);
        if (crossings.count > 0)
            issue("crossing", crossings.first,
                  fmt::format("{}: the contour on layer {} crosses or touches itself at {}{}", facts.piece,
                              layer_.layer, place_text(crossings.first),
                              crossings.count > 1 ? fmt::format(" and {} other places", crossings.count - 1) : ""));
        return found;
    }

    /// Reports an open line on a layer for cutting or sewing, where every line must be closed.
    bool tell_open(const JoinedLine& line) {
        const double length = line_length(line);
        const Gap gap = nearest_gap(open_, line);
        if (gap.width < 0.2 * length)
            tell_gap(line, gap);
        else
            issue("open", gap.from,
                  fmt::format("{}: a line of {} mm on layer {} is not closed, it ends at {}; close it or put it "
                              "on a layer for lines that are not cut",
                              piece_name(survey_, layer_.group, line.points), format_fixed(length / millimetre, 1),
                              layer_.layer, place_text(gap.from)));
        return true;
    }

    /// Reports an open outline where no layer tells what is cut: a line whose ends nearly meet, or that surrounds
    /// cloth outside of every contour.
    bool tell_open_outline(const JoinedLine& line, const std::vector<FoundContour>& contours) {
        const double length = line_length(line);
        const Gap gap = nearest_gap(open_, line);
        const bool is_mark = is_within_one(line, contours);
        if (gap.width < (is_mark ? 0.01 : 0.2) * length) {
            tell_gap(line, gap);
            return true;
        }
        // 0.02 is a strip 12 times as long as wide; a circle has 0.08.
        const double own_gap = (line.points.row(0) - line.points.row(line.points.rows() - 1)).norm();
        if (is_mark || std::abs(signed_area(line.points)) < 0.02 * std::pow(length + own_gap, 2)) return false;
        issue("open", gap.from,
              fmt::format(
                  "{}: a line of {} mm on layer {} surrounds cloth but is not closed, its ends are {} mm apart at "
                  "{} and {}; close it",
                  piece_name(survey_, layer_.group, line.points), format_fixed(length / millimetre, 1), layer_.layer,
                  format_fixed(own_gap / millimetre, 1), place_text(line.points.row(0)),
                  place_text(line.points.row(line.points.rows() - 1))));
        return true;
    }

    void tell_gap(const JoinedLine& line, const Gap& gap) {
        issue("gap", gap.from,
              fmt::format("{}: the contour on layer {} is open by {} mm between {} and {}; join its ends",
                          piece_name(survey_, layer_.group, line.points), layer_.layer,
                          format_fixed(gap.width / millimetre, 3), place_text(gap.from), place_text(gap.to)));
    }

    static bool is_within_one(const JoinedLine& line, const std::vector<FoundContour>& contours) {
        const Vec2 middle = line.points.row(line.points.rows() / 2);
        return std::any_of(contours.begin(), contours.end(), [&middle](const FoundContour& contour) {
            return (middle.array() >= contour.facts.lower.array()).all() &&
                   (middle.array() <= contour.facts.upper.array()).all() && contains(contour.points, middle);
        });
    }

    /// Cutters see the drawing from above, so a contour that is not level is cut too short.
    void check_plane(const JoinedLine& line, const std::string& piece) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const int number : line.lines) {
            const DrawnPath& path = *layer_.paths[static_cast<std::size_t>(number)];
            low = std::min(low, path.low * survey_.metres_per_unit);
            high = std::max(high, path.high * survey_.metres_per_unit);
        }
        constexpr double flat = 0.1 * millimetre;
        if (high - low <= flat) return;
        issue("out_of_plane", line.points.row(0),
              fmt::format(
                  "{}: the contour on layer {} is not in a horizontal plane, it rises by {} mm; flatten the piece "
                  "before you export it",
                  piece, layer_.layer, format_fixed((high - low) / millimetre, 1)));
    }

    void issue(const char* code, const Vec2& at, const std::string& message) {
        survey_.check.issues.push_back({code, message, true, at});
    }

    DrawingSurvey& survey_;
    const LayerLines& layer_;
    LayerUse use_;
    std::vector<Ring> closed_;
    std::vector<const JoinedLine*> open_;
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
    const double tolerance = drawn_precision / survey.metres_per_unit;
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
    std::vector<ContourFinder> finders;
    for (const LayerLines& layer : layers) finders.emplace_back(survey, layer).add_to(contours);
    for (ContourFinder& finder : finders) finder.report_open(contours);
    return contours;
}

}  // namespace ripstop
