#include "ripstop/pattern/drawing/check_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/stated_unit.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/drawing/drawing_lines.h"
#include "ripstop/pattern/drawing/drawing_overlaps.h"

namespace ripstop {
namespace {

constexpr double join_tolerance = 0.01 * millimetre;
constexpr double smallest_piece = 5 * millimetre, largest_piece = 80;  // [m]: sizes beyond these suggest a wrong unit

std::string millimetres(double metres, int decimals = 1) {
    return format_fixed(metres / millimetre, decimals);
}

bool is_curve(const UnreadEntity& entity) {
    static const std::set<std::string> curves{"SPLINE without control points", "MLINE", "REGION"};
    return entity.may_be_cut || curves.contains(entity.kind);
}

class Checker {
  public:
    Checker(const PatternDrawing& drawing, const DrawingCheckOptions& options)
        : drawing_(drawing),
          options_(options),
          unit_(find_unit()),
          survey_{drawing, convention_of(drawing), unit_.metres, check_} {}

    DrawingCheck run() {
        check_.format = drawing_.format;
        check_.convention = convention_text(survey_.convention);
        count_layers();
        const std::vector<LayerLines> layers = join_layers(sound_lines(survey_), unit_.metres, join_tolerance);
        measure_square(layers);
        contours_ = find_contours(survey_, layers);
        if (square_) drop_square();
        check_sizes();
        check_overlaps(survey_, contours_);
        if (survey_.convention == LayerConvention::numbered) check_blocks();
        check_texts();
        check_unread();
        if (contours_.empty())
            add("no_contour",
                "nothing in the drawing is a closed contour, so there is no piece to cut; close the outlines");
        for (FoundContour& contour : contours_) check_.contours.push_back(std::move(contour.facts));
        return std::move(check_);
    }

  private:
    void add(const char* code, const std::string& message, const std::optional<Vec2>& at = {}, bool is_wrong = true) {
        check_.issues.push_back({code, message, is_wrong, at});
    }

    LengthUnit find_unit() {
        const StatedUnit* best = drawing_.units.empty() ? nullptr : &drawing_.units.front();
        for (const StatedUnit& stated : drawing_.units)
            if (stated.unit.name != best->unit.name)
                add("unit_conflict", fmt::format("{} says {} and {} says {}; readers choose either, so make them agree",
                                                 best->where, best->unit.name, stated.where, stated.unit.name));
        if (options_.unit) {
            check_.unit = options_.unit;
            check_.unit_from = "--unit";
            if (best && best->unit.name != options_.unit->name)
                add("unit_conflict",
                    fmt::format("{} says {}, not {}", best->where, best->unit.name, options_.unit->name));
        } else if (best) {
            check_.unit = best->unit;
            check_.unit_from = best->where;
        } else {
            add("unit",
                "the file does not say its unit, taken as millimetres; readers guess inches, millimetres or 1/72 inch, "
                "so export it with one ($INSUNITS, a text \"Units: METRIC\", a width in mm), or give --unit");
        }
        return check_.unit.value_or(LengthUnit{"mm", millimetre});
    }

    void count_layers() {
        std::map<std::string, DrawingLayer> layers;
        for (const DrawnPath& path : drawing_.paths) ++layers[path.layer].lines;
        for (const DrawnPoint& point : drawing_.points) ++layers[point.layer].points;
        for (const DrawnText& text : drawing_.texts) ++layers[text.layer].texts;
        for (auto& [name, layer] : layers) {
            layer.name = name;
            check_.layers.push_back(layer);
        }
    }

    static bool is_square(const JoinedLine& line, double side) {
        if (!line.is_closed || line.points.rows() != 4) return false;
        for (int i = 0; i < 4; ++i)
            if (std::abs((line.points.row(i) - line.points.row((i + 1) % 4)).norm() - side) > 0.01 * side) return false;
        return true;
    }

    /// Measures a square that contains a length as text, such as `100 mm`.
    void measure_square(const std::vector<LayerLines>& layers) {
        for (const LayerLines& layer : layers)
            for (const JoinedLine& line : layer.lines) {
                const double side = line_length(line) / 4;
                if (square_ || !is_square(line, side)) continue;
                for (const DrawnText& text : drawing_.texts)
                    if (contains(line.points, Vec2(text.at * unit_.metres))) take_square(line, side, text.text);
            }
    }

    void take_square(const JoinedLine& line, double side, const std::string& text) {
        const auto stated = stated_length(text);
        if (square_ || !stated || !stated->unit || stated->number <= 0) return;
        square_ = line.points;
        check_.square = side;
        const double wanted = stated->number * stated->unit->metres;
        if (std::abs(side - wanted) > 0.001 * wanted)
            add("square",
                fmt::format("the reference square of {} measures {} mm: everything is {:.4g} times its size", text,
                            millimetres(side, 3), side / wanted),
                Vec2(line.points.row(0)));
    }

    void drop_square() {
        std::erase_if(contours_, [this](const FoundContour& contour) {
            return contour.points.rows() == square_->rows() && contour.points == *square_;
        });
    }

    void check_sizes() {
        for (const FoundContour& contour : contours_) {
            if (!contour.facts.is_cut) continue;
            const Vec2 size = contour.facts.upper - contour.facts.lower;
            const std::string text =
                fmt::format("{} is {} x {} mm", contour.facts.piece, millimetres(size.x()), millimetres(size.y()));
            const bool is_piece = survey_.convention != LayerConvention::unknown;
            if (size.maxCoeff() > largest_piece || (is_piece && size.maxCoeff() < smallest_piece))
                add("size", text + ", an impossible size for a piece; is the unit right?", contour.facts.lower);
            const double width = options_.roll ? width_across_grain(contour) : 0;
            if (options_.roll && width > *options_.roll)
                add("roll",
                    fmt::format("{}: {} mm across the grain, too wide for a roll of {} mm", text, millimetres(width),
                                millimetres(*options_.roll)),
                    contour.facts.lower);
        }
    }

    /// The width of a piece across its grain line; without one, the smaller width, because it may lie either way.
    double width_across_grain(const FoundContour& contour) const {
        Vec2 grain = Vec2::Zero();
        for (const DrawnPath& path : drawing_.paths) {
            if (use_of(survey_.convention, path.layer) != LayerUse::grain || path.points.rows() < 2) continue;
            const Vec2 from = path.points.row(0), to = path.points.row(path.points.rows() - 1);
            const Vec2 middle = (from + to) / 2 * unit_.metres;
            const bool is_its = contour.group >= 0 ? path.group == contour.group : contains(contour.points, middle);
            if (is_its && (to - from).norm() > grain.norm()) grain = to - from;
        }
        const Vec2 size = contour.facts.upper - contour.facts.lower;
        if (grain.norm() == 0) return size.minCoeff();
        const Vec2 across = Vec2(-grain.y(), grain.x()).normalized();
        const Eigen::VectorXd heights = contour.points * across;
        return heights.maxCoeff() - heights.minCoeff();
    }

    void check_blocks() {
        std::map<int, int> boundaries;
        for (const FoundContour& contour : contours_) boundaries[contour.group] += contour.facts.layer == "1";
        for (std::size_t g = 0; g < drawing_.groups.size(); ++g) {
            const DrawingGroup& group = drawing_.groups[g];
            if (group.insertions == 0) {
                add("block", fmt::format("block {} is never inserted; readers that take every block as a piece and "
                                         "those that take only inserted blocks see different patterns",
                                         group.name));
                continue;
            }
            ++check_.blocks;
            const int count = boundaries[static_cast<int>(g)];
            if (count != 1)
                add("block",
                    fmt::format("block {} has {} closed boundaries on layer 1, expected one: a block is a piece",
                                group.name, count));
        }
        if (boundaries[-1] > 0) add("block", "contours on layer 1 lie outside of any block; a piece is a block");
        for (const DrawingLayer& layer : check_.layers)
            if (layer.name == "0" || layer.name.find_first_not_of("0123456789") != std::string::npos)
                add("layer",
                    fmt::format("layer {} holds {} lines, points and texts, which readers of numbered layers drop; "
                                "they know layers 1 to 15 and 80 to 87 only",
                                layer.name, layer.lines + layer.points + layer.texts));
    }

    void check_texts() {
        std::map<int, std::vector<const FoundContour*>> cut;
        for (const FoundContour& contour : contours_)
            if (contour.facts.is_cut) cut[by_group() ? contour.group : 0].push_back(&contour);
        std::set<std::string> said;
        for (const DrawnText& text : drawing_.texts) {
            if (use_of(survey_.convention, text.layer) != LayerUse::text || text.text.empty()) continue;
            const Vec2 at = text.at * unit_.metres;
            const auto& around = cut[by_group() ? text.group : 0];
            const auto holds = [&at](const FoundContour* contour) {
                return (at.array() >= contour->facts.lower.array()).all() &&
                       (at.array() <= contour->facts.upper.array()).all() && contains(contour->points, at);
            };
            if (std::none_of(around.begin(), around.end(), holds) && said.insert(text.text).second)
                add("text_outside",
                    fmt::format("the text \"{}\" at {} lies on no piece, so it is lost when the pieces are taken apart",
                                text.text, place_text(at)),
                    at, false);
        }
    }

    bool by_group() const { return survey_.convention == LayerConvention::numbered; }

    void check_unread() {
        for (const UnreadEntity& entity : drawing_.unread) {
            const std::optional<Vec2> at = entity.at ? std::optional(Vec2(*entity.at * unit_.metres)) : std::nullopt;
            add("unread", unread_text(entity, unit_.metres), at, is_curve(entity));
        }
    }

    const PatternDrawing& drawing_;
    const DrawingCheckOptions& options_;
    DrawingCheck check_;
    LengthUnit unit_;
    DrawingSurvey survey_;
    std::vector<FoundContour> contours_;
    std::optional<Points2> square_;
};

}  // namespace

std::string unread_text(const UnreadEntity& entity, double metres_per_unit) {
    std::string what = entity.kind;
    if (entity.reason.empty()) what = fmt::format("{} {}", entity.count, entity.kind);
    if (!entity.layer.empty()) what += " on layer " + entity.layer;
    if (entity.at) what += " at " + place_text(*entity.at * metres_per_unit);
    if (!entity.reason.empty() && entity.count > 1)
        return fmt::format("line {}: {} {}; and {} more like this", entity.line, what, entity.reason, entity.count - 1);
    return fmt::format("line {}: {} {}", entity.line, what,
                       !entity.reason.empty() ? entity.reason
                       : is_curve(entity)     ? "cannot be checked, and many cutters cannot cut it; export polylines"
                                              : "not checked");
}

DrawingCheck check_drawing(const PatternDrawing& drawing, const DrawingCheckOptions& options) {
    return Checker(drawing, options).run();
}

}  // namespace ripstop
