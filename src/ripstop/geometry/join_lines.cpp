#include "ripstop/geometry/join_lines.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace ripstop {
namespace {

struct LineEnd {
    int line;
    bool is_last;
};

class Joiner {
  public:
    Joiner(const std::vector<Points2>& lines, double tolerance)
        : lines_(lines), tolerance_(tolerance), used_(lines.size(), false) {
        for (int i = 0; i < static_cast<int>(lines.size()); ++i)
            if (lines[static_cast<std::size_t>(i)].rows() > 1)
                for (const bool is_last : {false, true}) cells_[cell(at({i, is_last}))].push_back({i, is_last});
        for (int i = 0; i < static_cast<int>(lines.size()); ++i) dangling_.push_back(dangles(i));
    }

    /// Whether the line has an end at which no other line begins. A ring prefers lines that continue.
    bool is_dangling(int line) const { return dangling_[static_cast<std::size_t>(line)]; }

    JoinedLine from(int line) {
        std::deque<LineEnd> chain{{line, false}};  // each entry names the end at which the chain enters its line
        used_[static_cast<std::size_t>(line)] = true;
        const bool has_ends = lines_[static_cast<std::size_t>(line)].rows() > 1;
        const auto leaving = [](const LineEnd& entry) { return LineEnd{entry.line, !entry.is_last}; };
        while (has_ends && !closes(chain))
            if (const auto next = nearest(at(leaving(chain.back()))))
                take(chain, chain.end(), *next);
            else
                break;
        while (has_ends && !closes(chain))
            if (const auto next = nearest(at(chain.front())))
                take(chain, chain.begin(), leaving(*next));
            else
                break;
        return joined(chain, has_ends && closes(chain));
    }

    bool is_used(int line) const { return used_[static_cast<std::size_t>(line)]; }

  private:
    using Cell = std::pair<long long, long long>;

    Cell cell(const Vec2& p) const {
        return {static_cast<long long>(std::floor(p.x() / tolerance_)),
                static_cast<long long>(std::floor(p.y() / tolerance_))};
    }

    Vec2 at(const LineEnd& end) const {
        const Points2& points = lines_[static_cast<std::size_t>(end.line)];
        return points.row(end.is_last ? points.rows() - 1 : 0);
    }

    /// Whether the chain's two ends meet. A line with two points only returns along itself, so it closes nothing.
    bool closes(const std::deque<LineEnd>& chain) const {
        const Points2& first = lines_[static_cast<std::size_t>(chain.front().line)];
        const Vec2 end = at({chain.back().line, !chain.back().is_last});
        return (chain.size() > 1 || first.rows() > 2) && (end - at(chain.front())).norm() <= tolerance_;
    }

    /// Calls `visit(end, distance)` for every end within the tolerance.
    template <class Visit>
    void for_each_near(const Vec2& place, Visit&& visit) const {
        const auto [x, y] = cell(place);
        for (long long i = x - 1; i <= x + 1; ++i)
            for (long long j = y - 1; j <= y + 1; ++j) {
                const auto found = cells_.find({i, j});
                if (found == cells_.end()) continue;
                for (const LineEnd& end : found->second) {
                    const double distance = (at(end) - place).norm();
                    if (distance <= tolerance_) visit(end, distance);
                }
            }
    }

    bool dangles(int line) const {
        if (lines_[static_cast<std::size_t>(line)].rows() < 2) return true;
        for (const bool is_last : {false, true}) {
            bool meets_another = false;
            for_each_near(at({line, is_last}), [&](const LineEnd& end, double) {
                meets_another = meets_another || end.line != line || end.is_last != is_last;
            });
            if (!meets_another) return true;
        }
        return false;
    }

    std::optional<LineEnd> nearest(const Vec2& place) const {
        std::optional<LineEnd> best;
        std::tuple<bool, double, int> least;
        for_each_near(place, [&](const LineEnd& end, double distance) {
            if (is_used(end.line)) return;
            const std::tuple<bool, double, int> rank{is_dangling(end.line), distance, end.line};
            if (best && least <= rank) return;
            best = end;
            least = rank;
        });
        return best;
    }

    void take(std::deque<LineEnd>& chain, std::deque<LineEnd>::iterator where, const LineEnd& end) {
        used_[static_cast<std::size_t>(end.line)] = true;
        chain.insert(where, end);
    }

    JoinedLine joined(const std::deque<LineEnd>& chain, bool is_closed) const {
        JoinedLine result{{}, {}, is_closed};
        Eigen::Index count = 0;
        for (const LineEnd& entry : chain) count += lines_[static_cast<std::size_t>(entry.line)].rows();
        result.points.resize(count, 2);
        Eigen::Index next = 0;
        for (const LineEnd& entry : chain) {
            const Points2& points = lines_[static_cast<std::size_t>(entry.line)];
            result.lines.push_back(entry.line);
            // Two lines share the point where they meet: skip it the second time.
            for (Eigen::Index i = next > 0 ? 1 : 0; i < points.rows(); ++i)
                result.points.row(next++) = points.row(entry.is_last ? points.rows() - 1 - i : i);
        }
        if (is_closed && next > 1) --next;
        result.points.conservativeResize(next, 2);
        return result;
    }

    const std::vector<Points2>& lines_;
    double tolerance_;
    std::vector<bool> used_, dangling_;
    std::map<Cell, std::vector<LineEnd>> cells_;
};

}  // namespace

std::vector<JoinedLine> join_lines(const std::vector<Points2>& lines, double tolerance) {
    Joiner joiner(lines, tolerance);
    std::vector<JoinedLine> joined;
    for (const bool dangling : {false, true})
        for (int i = 0; i < static_cast<int>(lines.size()); ++i)
            if (!joiner.is_used(i) && joiner.is_dangling(i) == dangling) joined.push_back(joiner.from(i));
    const auto first = [](const JoinedLine& line) { return *std::min_element(line.lines.begin(), line.lines.end()); };
    std::sort(joined.begin(), joined.end(),
              [&first](const JoinedLine& a, const JoinedLine& b) { return first(a) < first(b); });
    return joined;
}

}  // namespace ripstop
