#include "ripstop/pattern/drawing/drawing_overlaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/cut/outline_relation.h"
#include "ripstop/pattern/drawing/drawing_openings.h"

namespace ripstop {
namespace {

constexpr double overlap_tolerance = 0.1 * millimetre;  // neither cutters nor arcs drawn as chords are more precise
constexpr double side_tolerance = 0.01 * millimetre;    // as for duplicate lines
constexpr int most_told = 1000;

/// A mark that only pieces have, and its place.
struct Mark {
    Vec2 at;
    const char* what;
};

bool is_in_box(const Vec2& point, const DrawingContour& contour) {
    return (point.array() >= contour.lower.array()).all() && (point.array() <= contour.upper.array()).all();
}

class OverlapFinder {
  public:
    OverlapFinder(DrawingSurvey& survey, const std::vector<FoundContour>& contours)
        : survey_(survey),
          contours_(contours),
          outlines_(contours.size()),
          parents_(contours.size(), -1),
          sew_(contours.size()) {}

    void run() {
        sweep();
        if (survey_.convention == LayerConvention::unknown) return;
        if (survey_.convention == LayerConvention::named) check_holes();
        for (std::size_t i = 0; i < contours_.size(); ++i)
            if (contours_[i].use == LayerUse::sew && has_area(i)) sew_[i].is_held ? check_opening(i) : report_sew(i);
    }

  private:
    /// Where a sew line lies.
    struct Sewn {
        bool is_held = false;
        int crossed = -1;  // index of a cut contour
        int holder = -1;   // index of the smallest cut contour around it
    };

    bool has_area(std::size_t i) const { return contours_[i].points.rows() > 2; }

    int sheet_of(const FoundContour& contour) const {
        return survey_.convention == LayerConvention::numbered ? contour.group : 0;
    }

    const IndexedOutline& outline(std::size_t i) {
        if (!outlines_[i]) outlines_[i] = std::make_unique<IndexedOutline>(contours_[i].points);
        return *outlines_[i];
    }

    void sweep() {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < contours_.size(); ++i)
            if (has_area(i)) order.push_back(i);
        std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
            return contours_[a].facts.lower.x() < contours_[b].facts.lower.x();
        });
        for (std::size_t a = 0; a < order.size(); ++a) {
            const FoundContour& first = contours_[order[a]];
            for (std::size_t b = a + 1; b < order.size() && told_ < most_told; ++b) {
                const FoundContour& second = contours_[order[b]];
                // Because of rounding, a sew line that coincides with its cut line may begin before it.
                if (second.facts.lower.x() > first.facts.upper.x() + overlap_tolerance) break;
                if (second.facts.lower.y() > first.facts.upper.y() + overlap_tolerance ||
                    second.facts.upper.y() < first.facts.lower.y() - overlap_tolerance ||
                    sheet_of(first) != sheet_of(second))
                    continue;
                compare(std::min(order[a], order[b]), std::max(order[a], order[b]));
            }
        }
    }

    void compare(std::size_t a, std::size_t b) {
        const bool is_cut_a = contours_[a].facts.is_cut, is_cut_b = contours_[b].facts.is_cut;
        if (is_cut_a && is_cut_b)
            compare_cuts(a, b);
        else if (is_cut_a || is_cut_b)
            place_sew(is_cut_a ? b : a, is_cut_a ? a : b);
    }

    void compare_cuts(std::size_t a, std::size_t b) {
        const OutlineRelation found = relate(outline(a), outline(b), overlap_tolerance);
        const bool is_one_layer =
            survey_.convention != LayerConvention::unknown || contours_[a].facts.layer == contours_[b].facts.layer;
        if (found.relation == Relation::within) take_parent(a, b);
        if (found.relation == Relation::around) take_parent(b, a);
        if (found.relation == Relation::crossing)
            tell("overlap", found.overlap.at,
                 fmt::format("{} overlap by {} mm at {}; cutting one cuts into the other, so move them apart",
                             names(a, b), format_fixed(found.overlap.distance / millimetre, 2),
                             place_text(found.overlap.at)),
                 is_one_layer);
        if (found.relation != Relation::same && found.relation != Relation::crossing) check_common_side(a, b);
        if (found.relation == Relation::same && is_one_layer)
            tell("overlap", contours_[a].facts.lower,
                 fmt::format("{} lie on each other at {}; delete one of them or move it", names(a, b),
                             place_text(contours_[a].facts.lower)));
    }

    /// Adjacent pieces may share a cut, but the cutter must know.
    void check_common_side(std::size_t a, std::size_t b) {
        constexpr double shortest = 1 * millimetre;
        const CommonSide common = common_side(outline(a), outline(b), side_tolerance);
        if (common.length >= shortest)
            tell("common_side", common.at,
                 fmt::format("{} share {} mm of their outlines from {} on, which is cut twice", names(a, b),
                             format_fixed(common.length / millimetre, 1), place_text(common.at)),
                 false);
    }

    void take_parent(std::size_t child, std::size_t parent) {
        const int now = parents_[child];
        if (now < 0 || contours_[static_cast<std::size_t>(now)].facts.area > contours_[parent].facts.area)
            parents_[child] = static_cast<int>(parent);
    }

    void place_sew(std::size_t sew, std::size_t cut) {
        const int holder = sew_[sew].holder;
        if (holder >= 0 && contours_[static_cast<std::size_t>(holder)].facts.area <= contours_[cut].facts.area) return;
        const Relation relation = relate(outline(sew), outline(cut), overlap_tolerance).relation;
        if (relation == Relation::within || relation == Relation::same) {
            sew_[sew].is_held = true;
            sew_[sew].holder = static_cast<int>(cut);
        }
        if (relation == Relation::crossing || relation == Relation::around) sew_[sew].crossed = static_cast<int>(cut);
    }

    /// From the outside in: a contour inside a piece is a hole, a contour inside a hole is a piece.
    void check_holes() {
        std::vector<std::size_t> order(contours_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
            return contours_[a].facts.area > contours_[b].facts.area;
        });
        std::vector<bool> is_hole(contours_.size(), false);
        std::vector<std::vector<std::size_t>> children(contours_.size());
        for (std::size_t i = 0; i < contours_.size(); ++i)
            if (parents_[i] >= 0) children[static_cast<std::size_t>(parents_[i])].push_back(i);
        for (const std::size_t i : order) {
            if (parents_[i] < 0 || is_hole[static_cast<std::size_t>(parents_[i])]) continue;
            is_hole[i] = true;
            const Mark* mark = mark_in(i, children[i]);
            if (!mark) continue;
            is_hole[i] = false;
            const std::size_t parent = static_cast<std::size_t>(parents_[i]);
            tell("overlap", contours_[i].facts.lower,
                 fmt::format("{} overlap: the one at {} is inside the other and not a hole, as {} at {} shows; move it",
                             names(parent, i), place_text(contours_[i].facts.lower), mark->what, place_text(mark->at)));
        }
    }

    const std::vector<Mark>& marks() {
        if (marks_) return *marks_;
        marks_.emplace();
        const double unit = survey_.metres_per_unit;
        for (const DrawnText& text : survey_.drawing.texts)
            if (!text.text.empty() && use_of(survey_.convention, text.layer) != LayerUse::reference)
                marks_->push_back({text.at * unit, "the text"});
        for (const DrawnPath& path : survey_.drawing.paths)
            if (use_of(survey_.convention, path.layer) == LayerUse::grain)
                marks_->push_back({Vec2(path.points.row(0)) * unit, "the grain line"});
        for (const FoundContour& contour : contours_)
            if (contour.use == LayerUse::sew) marks_->push_back({contour.points.row(0), "the sew line"});
        std::sort(marks_->begin(), marks_->end(), [](const Mark& a, const Mark& b) { return a.at.x() < b.at.x(); });
        return *marks_;
    }

    /// A mark inside the contour and outside of its children.
    const Mark* mark_in(std::size_t i, const std::vector<std::size_t>& children) {
        const DrawingContour& facts = contours_[i].facts;
        const std::vector<Mark>& all = marks();
        const auto holds = [this](std::size_t contour, const Vec2& at) {
            return is_in_box(at, contours_[contour].facts) && outline(contour).contains(at);
        };
        auto mark = std::lower_bound(all.begin(), all.end(), facts.lower.x(),
                                     [](const Mark& m, double x) { return m.at.x() < x; });
        for (; mark != all.end() && mark->at.x() <= facts.upper.x(); ++mark)
            if (holds(i, mark->at) && outline(i).distance(mark->at) > overlap_tolerance &&
                std::none_of(children.begin(), children.end(),
                             [&](std::size_t child) { return holds(child, mark->at); }))
                return &*mark;
        return nullptr;
    }

    void report_sew(std::size_t sew) {
        const DrawingContour& facts = contours_[sew].facts;
        const int crossed = sew_[sew].crossed;
        if (crossed < 0)
            return tell("sew_outside", facts.lower,
                        fmt::format("{}: the contour on layer {} at {} lies in no closed contour that is cut, so there "
                                    "is no cloth to sew; move it, or draw what is cut",
                                    facts.piece, facts.layer, place_text(facts.lower)));
        const std::size_t cut = static_cast<std::size_t>(crossed);
        const Protrusion out = reach_outside(outline(sew), outline(cut));
        tell(
            "sew_outside", out.at,
            fmt::format("{}: the contour on layer {} reaches {} mm out of the one on layer {} at {}, where there is no "
                        "cloth to sew; move one of them",
                        contours_[cut].facts.piece, facts.layer, format_fixed(out.distance / millimetre, 2),
                        contours_[cut].facts.layer, place_text(out.at)));
    }

    /// True if the sew line belongs to a hole, or is drawn inside the piece.
    bool is_within_sew_line(std::size_t sew) {
        for (std::size_t i = 0; i < contours_.size(); ++i)
            if (i != sew && sew_[i].holder == sew_[sew].holder && sew_[i].is_held &&
                contours_[i].facts.area > contours_[sew].facts.area &&
                outline(i).contains(contours_[sew].points.row(0)))
                return true;
        return false;
    }

    /// An opening of a sew line must be cut: by the contour around the sew line, or by one inside that.
    void check_opening(std::size_t sew) {
        const int holder = sew_[sew].holder;
        if (is_within_sew_line(sew)) return;
        std::vector<const Points2*> cut_lines;
        for (std::size_t i = 0; i < contours_.size(); ++i)
            if (contours_[i].facts.is_cut && (static_cast<int>(i) == holder || parents_[i] == holder))
                cut_lines.push_back(&contours_[i].points);
        const auto lost = find_lost_opening(contours_[sew].points, cut_lines);
        if (!lost) return;
        const DrawingContour& cut = contours_[static_cast<std::size_t>(holder)].facts;
        tell("opening", lost->at,
             fmt::format("{}: the contour on layer {} faces itself across {} mm at {}, and nothing on layer {} is cut "
                         "in between, so an opening bounded by {} mm of it is lost because two allowances merge; "
                         "draw its cut line",
                         cut.piece, contours_[sew].facts.layer, format_fixed(lost->width / millimetre, 1),
                         place_text(lost->at), cut.layer, format_fixed(lost->length / millimetre, 0)));
    }

    /// Both names, with their places if the names are equal.
    std::string names(std::size_t a, std::size_t b) const {
        const DrawingContour &first = contours_[a].facts, &second = contours_[b].facts;
        if (first.piece != second.piece) return first.piece + " and " + second.piece;
        return fmt::format("{} at {} and {} at {}", first.piece, place_text(first.lower), second.piece,
                           place_text(second.lower));
    }

    void tell(const char* code, const Vec2& at, const std::string& message, bool is_wrong = true) {
        if (++told_ <= most_told) survey_.check.issues.push_back({code, message, is_wrong, at});
    }

    DrawingSurvey& survey_;
    const std::vector<FoundContour>& contours_;
    std::vector<std::unique_ptr<IndexedOutline>> outlines_;  // built on first use
    std::vector<int> parents_;                               // the smallest cut contour around each, -1: none
    std::vector<Sewn> sew_;
    std::optional<std::vector<Mark>> marks_;
    int told_ = 0;
};

}  // namespace

void check_overlaps(DrawingSurvey& survey, const std::vector<FoundContour>& contours) {
    OverlapFinder(survey, contours).run();
}

}  // namespace ripstop
