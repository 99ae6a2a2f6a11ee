#include "ripstop/pattern/piece/seam_match.h"

#include <algorithm>
#include <numeric>

#include "ripstop/geometry/polygon.h"
#include "ripstop/model/plan/seam_place.h"
#include "ripstop/model/tile/seam_sheets.h"
#include "ripstop/pattern/piece/pieces.h"

namespace ripstop {
namespace {

constexpr double same_end = 1e-3;  // [m]

/// Union-find over seams. Each seam knows whether its direction is opposite to that of its group's root.
class Groups {
  public:
    explicit Groups(std::size_t seams) : to_(seams), against_(seams, false), torn_(seams, false) {
        std::iota(to_.begin(), to_.end(), 0);
    }
    void tie(int a, int b, bool reversed) {
        const auto [first, first_against] = root(static_cast<std::size_t>(a));
        const auto [other, other_against] = root(static_cast<std::size_t>(b));
        const bool against = (first_against != other_against) != reversed;
        if (first == other) {
            torn_[first] = torn_[first] || against;
            return;
        }
        const std::size_t low = std::min(first, other), high = std::max(first, other);
        to_[high] = low;
        against_[high] = against;
        torn_[low] = torn_[low] || torn_[high];
    }
    MarkDirection direction(std::size_t seam) {
        const auto [first, against] = root(seam);
        return torn_[first] ? MarkDirection::none : against ? MarkDirection::from_end : MarkDirection::from_start;
    }

  private:
    std::pair<std::size_t, bool> root(std::size_t seam) {
        if (to_[seam] == seam) return {seam, false};
        const auto [first, against] = root(to_[seam]);
        against_[seam] = against_[seam] != against;
        to_[seam] = first;
        return {first, against_[seam]};
    }

    std::vector<std::size_t> to_;
    std::vector<bool> against_, torn_;
};

}  // namespace

SeamEnds::SeamEnds(const CutPlan& plan) : runs_(plan.tiles.size()) {
    std::vector<Vec2> middles(plan.tiles.size(), Vec2::Zero());
    for (std::size_t t = 0; t < plan.tiles.size(); ++t)
        if (has_flat_positions(plan.tiles[t]))
            middles[t] = area_centroid(plan.tiles[t].flattening.positions(plan.tiles[t].tile.boundary, Eigen::all));
    const auto add = [&](const SeamSheet& sheet, const SeamSheet& other) {
        const auto t = static_cast<std::size_t>(sheet.side->tile);
        if (!has_flat_positions(plan.tiles[t])) return;
        const auto at = [&](double along) {
            along = std::clamp(other.record->along_skin(along), sheet.from, sheet.to);
            return Vec2(flat_point(plan.tiles[t], place_on_sheet(plan.tiles, sheet, along)) - middles[t]);
        };
        runs_[t].push_back({static_cast<int>(other.record - plan.seams.data()), at(0), at(other.record->length)});
    };
    for (const std::vector<SeamSheet>& sheets : sheets_of_seams(plan.seams))
        for (const SeamSheet& sheet : sheets)
            for (const SeamSheet& other : sheets) {
                const bool ends_within = other.record->into && other.from < sheet.to && other.to > sheet.from &&
                                         (other.from > sheet.from + same_end || other.to < sheet.to - same_end);
                if (&other == &sheet || ends_within) add(sheet, other);  // where one sheet ends, the other has a mark
            }
}

std::optional<std::vector<SeamMatch>> SeamEnds::match(std::size_t tile, std::size_t pattern, bool mirrored) const {
    const std::vector<Run>&runs = runs_[tile], &others = runs_[pattern];
    if (runs.size() != others.size()) return std::nullopt;
    for (const double half_turn : {1.0, -1.0}) {
        const Vec2 signs(half_turn, mirrored ? -half_turn : half_turn);
        const auto meet = [&](const Vec2& here, const Vec2& there) {
            return (here - there.cwiseProduct(signs)).norm() <= same_end;
        };
        std::vector<SeamMatch> matches;
        for (const Run& run : runs) {
            const auto found = std::find_if(others.begin(), others.end(), [&](const Run& other) {
                return (meet(run.start, other.start) && meet(run.end, other.end)) ||
                       (meet(run.start, other.end) && meet(run.end, other.start));
            });
            if (found == others.end()) break;
            matches.push_back({run.seam, found->seam, !meet(run.start, found->start)});
        }
        if (matches.size() == runs.size()) return matches;
    }
    return std::nullopt;
}

std::vector<MarkDirection> mark_directions(const CutPlan& plan) {
    const SeamEnds ends(plan);
    Groups groups(plan.seams.size());
    for (std::size_t t = 0; t < plan.tiles.size(); ++t) {
        const FlatTile& tile = plan.tiles[t];
        if (tile.equal_to < 0) continue;
        if (const auto matches = ends.match(t, static_cast<std::size_t>(tile.equal_to), tile.mirrored))
            for (const SeamMatch& match : *matches) groups.tie(match.seam, match.pattern_seam, match.reversed);
    }
    for (std::size_t s = 0; s < plan.seams.size(); ++s)  // all sheets of a seam have its marks
        if (const auto& into = plan.seams[s].into) groups.tie(static_cast<int>(s), into->seam, into->backwards);
    std::vector<MarkDirection> directions;
    for (std::size_t s = 0; s < plan.seams.size(); ++s) directions.push_back(groups.direction(s));
    return directions;
}

}  // namespace ripstop
