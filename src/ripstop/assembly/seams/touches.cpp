#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "ripstop/assembly/seams/seam_runs.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"

namespace ripstop {
namespace {

constexpr double opposed = 0.3;         // cosine: chains closer to perpendicular have neither direction
constexpr double fold = -0.5;           // cosine: an edge that turns back farther than this is a fold
constexpr double sagitta_share = 0.25;  // share of sagitta times turn: the possible error of a curve with enough
                                        // vertices
constexpr double unseen_share = 1.25;   // of the sagitta, for a chain with one edge, which shows no turn itself

struct EdgeRef {
    int chain, edge;
};

using Cell = std::array<long, 3>;
struct CellHash {
    std::size_t operator()(const Cell& c) const {
        return static_cast<std::size_t>(c[0]) * 73856093u ^ static_cast<std::size_t>(c[1]) * 19349663u ^
               static_cast<std::size_t>(c[2]) * 83492791u;
    }
};

double sagitta(const ChainCurve& curve, int edge) {
    return chord_of_edge(curve, edge) * turn_of_edge(curve, edge) / 8;
}

/// The largest possible error of an edge's curve.
double most_slack(const ChainCurve& curve, int edge, const Reach& reach) {
    const double unseen = curve.edge_count() == 1 ? 0.1 * chord_of_edge(curve, edge) : 0.0;
    return std::min(reach.most, unseen + sagitta_share * turn_of_edge(curve, edge) * sagitta(curve, edge));
}

/// Finds the edges near a place. Each edge is stored in every cell that it passes within its reach.
class EdgeGrid {
  public:
    EdgeGrid(const std::vector<PlacedChain>& chains, const Reach& reach) : size_(cell_size(chains, reach)) {
        for (int c = 0; c < static_cast<int>(chains.size()); ++c) {
            const ChainCurve& curve = chains[at(c)].curve;
            for (int e = 0; e < curve.edge_count(); ++e)
                add(curve, {c, e}, reach(curve, curve) + most_slack(curve, e, reach));
        }
    }
    const std::vector<EdgeRef>& near(const Vec3& point) const {
        static const std::vector<EdgeRef> none;
        const auto found = cells_.find(cell(point.array()));
        return found == cells_.end() ? none : found->second;
    }

  private:
    /// Adds an edge in pieces, because the bounding box of a long slanting edge has far more cells than the edge
    /// passes.
    void add(const ChainCurve& curve, const EdgeRef& edge, double around) {
        const double longest = chord_of_edge(curve, edge.edge) / size_;
        const int pieces = std::max(1, static_cast<int>(std::min(1e4, longest)));
        const double bend = 1.5 * sagitta(curve, edge.edge) / pieces / pieces;
        const Eigen::Array3d wide = Eigen::Array3d::Constant(around + bend);
        for (int k = 0; k < pieces; ++k) {
            const Eigen::Array3d p = point_at(curve, edge.edge + double(k) / pieces).array();
            const Eigen::Array3d q = point_at(curve, edge.edge + std::min(double(k + 1) / pieces, 1 - 1e-12)).array();
            const Cell low = cell(p.min(q) - wide), high = cell(p.max(q) + wide);
            for (long x = low[0]; x <= high[0]; ++x)
                for (long y = low[1]; y <= high[1]; ++y)
                    for (long z = low[2]; z <= high[2]; ++z) {
                        std::vector<EdgeRef>& there = cells_[{x, y, z}];
                        const bool listed =
                            !there.empty() && there.back().chain == edge.chain && there.back().edge == edge.edge;
                        if (!listed) there.push_back(edge);
                    }
        }
    }
    /// The cell size: the mean edge plus its reach, so that there are few edges per cell and few cells per edge.
    /// One huge tile counts no more than any other.
    static double cell_size(const std::vector<PlacedChain>& chains, const Reach& reach) {
        std::vector<double> sizes;
        for (const PlacedChain& chain : chains)
            sizes.push_back(chain.curve.length() / chain.curve.edge_count() + 2 * reach(chain.curve, chain.curve));
        if (sizes.empty()) return 1;
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        return *middle;
    }
    Cell cell(const Eigen::Array3d& point) const {
        Cell result;
        for (int k = 0; k < 3; ++k) result[at(k)] = static_cast<long>(std::floor(point[k] / size_));
        return result;
    }

    double size_;
    std::unordered_map<Cell, std::vector<EdgeRef>, CellHash> cells_;
};

/// The curvature of the chain at one of its vertices: turn per length [1/m].
double curvature_at(const ChainCurve& curve, int vertex) {
    double turn = 0, length = 0;
    for (int e = std::max(0, vertex - 1); e <= std::min(vertex, curve.edge_count() - 1); ++e) {
        turn += turn_of_edge(curve, e);
        length += chord_of_edge(curve, e);
    }
    return length > 0 ? turn / length : 0;
}

/// The possible error of an edge's curve at parameter t, from the edge itself and from the curvature of its
/// neighbour.
double slack_on_edge(const ChainCurve& curve, int edge, double t, double other_curvature, const Reach& reach) {
    const double chord = chord_of_edge(curve, edge);
    double slack = sagitta_share * turn_of_edge(curve, edge) * sagitta(curve, edge);
    if (curve.edge_count() == 1) slack += unseen_share * other_curvature * chord * chord / 8;
    return std::min(slack, most_slack(curve, edge, reach)) * 4 * t * (1 - t);
}

bool is_next_to(const ChainCurve& curve, int vertex, int edge) {
    const int count = curve.edge_count();
    if (edge == vertex || edge == vertex - 1) return true;
    return curve.closed && (edge == vertex % count || edge == (vertex + count - 1) % count);
}

/// Nothing runs alongside a chain past its end.
bool is_past_end(const ChainCurve& curve, const FootPoint& foot, const Vec3& point, double tolerance) {
    if (curve.closed || (foot.at > 0 && foot.at < curve.edge_count())) return false;
    return std::abs((point - point_at(curve, foot.at)).dot(direction_at(curve, foot.at))) > tolerance;
}

class TouchFinder {
  public:
    TouchFinder(const std::vector<PlacedChain>& chains, double tolerance)
        : chains_(chains), tolerance_(tolerance), reach_(make_reach(chains, tolerance)), grid_(chains, reach_) {}

    /// All touches of the vertices of one chain.
    std::vector<Touch> of_chain(int c) const {
        std::vector<Touch> touches;
        const ChainCurve& curve = chains_[static_cast<std::size_t>(c)].curve;
        for (int v = 0; v <= curve.edge_count(); ++v) add_touches(c, v, touches);
        for (int v = 1; v < curve.edge_count(); ++v)
            if (direction_from(curve, v).dot(direction_to(curve, v)) < fold)
                touches.push_back({c, c, double(v), double(v), 0, 0, false});
        return touches;
    }

  private:
    static Vec3 direction_to(const ChainCurve& curve, int v) { return Vec3(curve.end_slopes.row(v - 1)).normalized(); }
    static Vec3 direction_from(const ChainCurve& curve, int v) { return Vec3(curve.start_slopes.row(v)).normalized(); }

    void add_touches(int c, int v, std::vector<Touch>& touches) const {
        const ChainCurve& own = chains_[static_cast<std::size_t>(c)].curve;
        const Vec3 point = own.points.row(v);
        const Vec3 before = v > 0 ? direction_to(own, v) : direction_from(own, v);
        const Vec3 after = v < own.edge_count() ? direction_from(own, v) : before;
        const double curvature = curvature_at(own, v);
        const std::size_t first = touches.size();
        for (const EdgeRef& at : grid_.near(point)) {
            if (at.chain == c && is_next_to(own, v, at.edge)) continue;
            const ChainCurve& other = chains_[static_cast<std::size_t>(at.chain)].curve;
            const double range =
                reach_(own, other) + most_slack(other, at.edge, reach_) + 1.5 * sagitta(other, at.edge);
            if (distance_to_chord(other, at.edge, point) > range) continue;
            const FootPoint foot = foot_on_edge(other, at.edge, point);
            const double slack = slack_on_edge(other, at.edge, foot.at - at.edge, curvature, reach_);
            if (foot.distance > std::max(reach_(own, other), tolerance_ + slack)) continue;
            if (is_past_end(other, foot, point, tolerance_)) continue;
            const Vec3 there = direction_at(other, foot.at);
            for (const bool same_way : {false, true}) {
                const double sign = same_way ? 1 : -1;
                if (std::max(sign * before.dot(there), sign * after.dot(there)) < opposed) continue;
                keep_nearest({c, at.chain, double(v), foot.at, foot.distance, slack, same_way}, first, touches);
            }
        }
        add_other_ends(first, touches);
        for (std::size_t i = first; i < touches.size(); ++i) {
            Touch& touch = touches[i];
            if (touch.a < touch.b || (touch.a == touch.b && touch.at_a <= touch.at_b)) continue;
            std::swap(touch.a, touch.b);
            std::swap(touch.at_a, touch.at_b);
        }
    }

    /// Adds touches at the end of a loop, which is also its start.
    void add_other_ends(std::size_t first, std::vector<Touch>& touches) const {
        constexpr double near = 1e-3;
        for (std::size_t i = first, end = touches.size(); i < end; ++i) {
            Touch twin = touches[i];
            const ChainCurve& other = chains_[static_cast<std::size_t>(twin.b)].curve;
            const double count = other.edge_count();
            if (!other.closed || (twin.at_b > near && twin.at_b < count - near)) continue;
            twin.at_b = twin.at_b > near ? 0 : count;
            touches.push_back(twin);
        }
    }

    static double distance_to_chord(const ChainCurve& curve, int edge, const Vec3& point) {
        const Vec3 start = curve.points.row(edge), chord = Vec3(curve.points.row(edge + 1)) - start;
        const double t = std::clamp((point - start).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        return (point - start - t * chord).norm();
    }

    static void keep_nearest(const Touch& touch, std::size_t first, std::vector<Touch>& touches) {
        for (std::size_t i = first; i < touches.size(); ++i)
            if (touches[i].b == touch.b && touches[i].same_way == touch.same_way) {
                if (std::tie(touch.distance, touch.at_b) < std::tie(touches[i].distance, touches[i].at_b))
                    touches[i] = touch;
                return;
            }
        touches.push_back(touch);
    }

    const std::vector<PlacedChain>& chains_;
    double tolerance_;
    Reach reach_;
    EdgeGrid grid_;
};

}  // namespace

double Reach::operator()(const ChainCurve& a, const ChainCurve& b) const {
    return std::max(least, std::min(0.05 * std::min(a.length(), b.length()), most));
}

Reach make_reach(const std::vector<PlacedChain>& chains, double tolerance) {
    std::vector<double> lengths;
    for (const PlacedChain& chain : chains) lengths.push_back(chain.curve.length());
    if (lengths.empty()) return {20 * tolerance, 0};
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return {20 * tolerance, *middle / 5};
}

std::vector<Touch> find_touches(const std::vector<PlacedChain>& chains, double tolerance) {
    const TouchFinder finder(chains, tolerance);
    std::vector<std::vector<Touch>> found(chains.size());
    parallel_for(static_cast<int>(chains.size()), 0, [&](int c) { found[at(c)] = finder.of_chain(c); });
    std::vector<Touch> touches;
    for (const std::vector<Touch>& some : found) touches.insert(touches.end(), some.begin(), some.end());
    std::sort(touches.begin(), touches.end(), [](const Touch& p, const Touch& q) {
        return std::tuple(p.a, p.b, p.same_way, p.at_a, p.same_way ? p.at_b : -p.at_b, p.distance) <
               std::tuple(q.a, q.b, q.same_way, q.at_a, q.same_way ? q.at_b : -q.at_b, q.distance);
    });
    return touches;
}

}  // namespace ripstop
