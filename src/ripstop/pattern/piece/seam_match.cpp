#include "ripstop/pattern/piece/seam_match.h"

#include <algorithm>

#include "ripstop/base/union_find.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/tile/seam_place.h"
#include "ripstop/tile/seam_sheets.h"

namespace ripstop {
namespace {

constexpr double same_end = 1e-3;  // [m]

/// The directions of seams' marks. Union-find over the seams, each as it runs (2 s) and reversed (2 s + 1); a tie
/// says that two seams run in equal or in opposite directions.
class Directions {
  public:
    explicit Directions(std::size_t seams) : sets_(2 * seams) {}
    void tie(int a, int b, bool reversed) {
        sets_.join(2 * a, 2 * b + (reversed ? 1 : 0));
        sets_.join(2 * a + 1, 2 * b + (reversed ? 0 : 1));
    }
    /// The direction relative to the first seam that it is tied to; none if the ties contradict each other.
    MarkDirection of(int seam) {
        const int root = sets_.root(2 * seam);
        if (root == sets_.root(2 * seam + 1)) return MarkDirection::none;
        return root % 2 == 0 ? MarkDirection::from_start : MarkDirection::from_end;
    }

  private:
    UnionFind sets_;
};

}  // namespace

SeamEnds::SeamEnds(const CutPlan& plan) : runs_(plan.tiles.size()) {
    std::vector<Vec2> middles(plan.tiles.size(), Vec2::Zero());
    for (std::size_t t = 0; t < plan.tiles.size(); ++t)
        if (plan.tiles[t].is_flat())
            middles[t] = area_centroid(plan.tiles[t].flattening.positions(plan.tiles[t].tile.boundary, Eigen::all));
    const auto add = [&](const SeamSheet& sheet, const SeamSheet& other) {
        const auto t = static_cast<std::size_t>(sheet.side->tile);
        if (!plan.tiles[t].is_flat()) return;
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
    const std::vector<SeamRun>&runs = runs_[tile], &others = runs_[pattern];
    if (runs.size() != others.size()) return std::nullopt;
    for (const double half_turn : {1.0, -1.0}) {
        const Vec2 signs(half_turn, mirrored ? -half_turn : half_turn);
        const auto meet = [&](const Vec2& here, const Vec2& there) {
            return (here - there.cwiseProduct(signs)).norm() <= same_end;
        };
        std::vector<SeamMatch> matches;
        for (const SeamRun& run : runs) {
            const auto found = std::find_if(others.begin(), others.end(), [&](const SeamRun& other) {
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
    Directions found(plan.seams.size());
    for (std::size_t t = 0; t < plan.tiles.size(); ++t) {
        const FlatTile& tile = plan.tiles[t];
        if (tile.equal_to < 0) continue;
        if (const auto matches = ends.match(t, static_cast<std::size_t>(tile.equal_to), tile.mirrored))
            for (const SeamMatch& match : *matches) found.tie(match.seam, match.pattern_seam, match.reversed);
    }
    for (std::size_t s = 0; s < plan.seams.size(); ++s)  // all sheets of a seam have its marks
        if (const auto& into = plan.seams[s].into) found.tie(static_cast<int>(s), into->seam, into->backwards);
    std::vector<MarkDirection> directions;
    for (std::size_t s = 0; s < plan.seams.size(); ++s) directions.push_back(found.of(static_cast<int>(s)));
    return directions;
}

}  // namespace ripstop
