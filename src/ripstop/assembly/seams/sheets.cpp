#include "ripstop/assembly/seams/sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <climits>
#include <cmath>
#include <map>
#include <set>

#include "ripstop/assembly/seams/one_sided.h"
#include "ripstop/base/union_find.h"

namespace ripstop {
namespace {

constexpr double shortest_touch = 4;                 // tolerances
constexpr double shortest_common = 0.25;             // share of the shorter chain
constexpr double competing = 0.5;                    // share of the shorter run
constexpr double named_inside = 20;                  // more than all geometric terms together
constexpr double skin_weighs = 3;                    // more than any angle
constexpr double least_skin = 0.5, all_skin = 0.75;  // of one-sidedness; a flap beside a sheet hides less
constexpr double clearly_lower = 0.3;                // difference of ranks
constexpr double rank_step = 1e-6;                   // smaller differences of ranks are rounding and count as equal
constexpr std::size_t most_samples = 16;

/// For each boundary edge of a tile, the direction into the tile, perpendicular to the edge.
class Inward {
  public:
    Inward(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains) : tiles_(tiles), chains_(chains) {}

    Vec3 at(int chain, double place) {
        const PlacedChain& placed = chains_[static_cast<std::size_t>(chain)];
        const int count = placed.curve.edge_count();
        int edge = std::min(static_cast<int>(std::floor(place)), placed.curve.closed ? INT_MAX : count - 1);
        edge = ((edge % count) + count) % count;
        return of_tile(placed.tile).row((placed.first_edge + edge) % placed.boundary_edges);
    }

  private:
    /// The direction from an edge to a point, perpendicular to the edge.
    static Vec3 across(const Tile& tile, int from, int to, const Vec3& point) {
        const Vec3 start = tile.mesh.positions.row(from);
        const Vec3 along = (Vec3(tile.mesh.positions.row(to)) - start).normalized(), way = point - start;
        return (way - along * along.dot(way)).normalized();
    }
    const Points3& of_tile(int t) {
        const auto known = found_.find(t);
        if (known != found_.end()) return known->second;
        const Tile& tile = tiles_[static_cast<std::size_t>(t)];
        const std::size_t count = tile.boundary.size();
        std::map<std::pair<int, int>, Eigen::Index> edges;
        for (std::size_t i = 0; i < count; ++i)
            edges[{tile.boundary[i], tile.boundary[(i + 1) % count]}] = static_cast<Eigen::Index>(i);
        Points3 inward = Points3::Zero(static_cast<Eigen::Index>(count), 3);
        if (tile.mesh.triangle_count() == 0) {  // an outline: towards its centre
            const Vec3 middle = tile.mesh.positions.colwise().mean().transpose();
            for (const auto& [edge, at] : edges) inward.row(at) = across(tile, edge.first, edge.second, middle);
        }
        const Triangles& corners = tile.mesh.triangles;
        for (Eigen::Index f = 0; f < corners.rows(); ++f)
            for (int c = 0; c < 3; ++c) {
                const auto edge = edges.find({corners(f, c), corners(f, (c + 1) % 3)});
                if (edge == edges.end()) continue;
                const Vec3 apex = tile.mesh.positions.row(corners(f, (c + 2) % 3));
                inward.row(edge->second) = across(tile, edge->first.first, edge->first.second, apex);
            }
        return found_[t] = std::move(inward);
    }

    const std::vector<Tile>& tiles_;
    const std::vector<PlacedChain>& chains_;
    std::map<int, Points3> found_;
};

/// The mean cosine between the two sheets along a run.
double mean_cosine(Inward& inward, const Run& run) {
    double sum = 0;
    const std::size_t steps = run.touches.size() - 1, samples = std::min(steps, most_samples);
    for (std::size_t k = 0; k < samples; ++k) {
        const std::size_t i = k * steps / samples;
        const Touch &p = run.touches[i], &q = run.touches[i + 1];
        sum += inward.at(run.a, (p.at_a + q.at_a) / 2).dot(inward.at(run.b, (p.at_b + q.at_b) / 2));
    }
    return sum / static_cast<double>(samples);
}

/// A run as seen along one of its chains.
struct Along {
    std::size_t run;
    double low, high;  ///< arc lengths [m]
};

class Competition {
  public:
    Competition(const std::vector<PlacedChain>& chains, const std::vector<const Run*>& runs, double tolerance)
        : runs_(runs), against_(runs.size()), groups_(runs.size()) {
        std::map<int, std::vector<Along>> on_chain;
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const Run& run = *runs[r];
            if (!is_long_run(chains, run, tolerance)) continue;
            const ChainCurve& a = chains[static_cast<std::size_t>(run.a)].curve;
            const ChainCurve& b = chains[static_cast<std::size_t>(run.b)].curve;
            on_chain[run.a].push_back({r, station_at(a, run.start_a()), station_at(a, run.end_a())});
            on_chain[run.b].push_back({r, station_at(b, run.low_b), station_at(b, run.high_b)});
        }
        for (const auto& [chain, some] : on_chain) {
            const ChainCurve& curve = chains[static_cast<std::size_t>(chain)].curve;
            for (std::size_t i = 0; i < some.size(); ++i)
                for (std::size_t j = i + 1; j < some.size(); ++j) compare(some[i], some[j], curve);
        }
    }

    const std::vector<std::size_t>& against(std::size_t run) const { return against_[run]; }
    std::size_t group(std::size_t run) { return at(groups_.root(static_cast<int>(run))); }

  private:
    void compare(const Along& p, const Along& q, const ChainCurve& curve) {
        const Run &one = *runs_[p.run], &other = *runs_[q.run];
        if (p.run == q.run || (one.a == other.a && one.b == other.b)) return;
        const double lap = curve.closed ? curve.length() : 0;
        double shared = 0;
        for (const double turn : {-lap, 0.0, lap}) {
            shared = std::max(shared, std::min(p.high, q.high + turn) - std::max(p.low, q.low + turn));
            if (lap == 0) break;
        }
        if (!(shared > competing * std::min(one.length, other.length))) return;
        against_[p.run].push_back(q.run);
        against_[q.run].push_back(p.run);
        groups_.join(static_cast<int>(p.run), static_cast<int>(q.run));
    }

    const std::vector<const Run*>& runs_;
    std::vector<std::vector<std::size_t>> against_;
    UnionFind groups_;
};

}  // namespace

bool is_long_run(const std::vector<PlacedChain>& chains, const Run& run, double tolerance) {
    const double shorter = std::min(chains[static_cast<std::size_t>(run.a)].curve.length(),
                                    chains[static_cast<std::size_t>(run.b)].curve.length());
    return run.length > shortest_touch * tolerance && run.length > shortest_common * shorter;
}

SheetOrder order_sheets(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                        std::vector<Run>& opposed, const std::vector<Run>& same_way, double tolerance) {
    std::vector<const Run*> runs;
    for (const Run& run : opposed) runs.push_back(&run);
    for (const Run& run : same_way) runs.push_back(&run);
    Competition competition(chains, runs, tolerance);
    Inward inward(tiles, chains);
    const auto tile_of = [&](int chain) {
        return static_cast<std::size_t>(chains[static_cast<std::size_t>(chain)].tile);
    };
    std::vector<char> competes(tiles.size(), false);
    for (std::size_t r = 0; r < runs.size(); ++r)
        for (const int chain : {runs[r]->a, runs[r]->b})
            if (!competition.against(r).empty()) competes[tile_of(chain)] = true;
    if (std::any_of(tiles.begin(), tiles.end(), [](const Tile& tile) { return tile.mesh.triangle_count() == 0; }))
        competes.assign(tiles.size(), false);  // outlines without triangles block no line of sight
    const std::vector<double> sided = one_sidedness(tiles, competes);
    std::vector<double> ranks(runs.size(), 0), longest(runs.size(), 0);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        double& length = longest[competition.group(r)];
        length = std::max(length, runs[r]->length);
        if (competition.against(r).empty()) continue;
        double rank = mean_cosine(inward, *runs[r]);
        for (const int chain : {runs[r]->a, runs[r]->b}) {
            const double skin = (sided[tile_of(chain)] - least_skin) / (all_skin - least_skin);
            rank += (tiles[tile_of(chain)].inside ? named_inside : 0) - skin_weighs * std::clamp(skin, 0.0, 1.0);
        }
        ranks[r] = std::round(rank / rank_step) * rank_step;
    }
    SheetOrder order;
    for (const Run* run : runs)
        if (is_long_run(chains, *run, tolerance)) order.beside.push_back(*run);
    for (std::size_t r = opposed.size(); r < runs.size(); ++r) {
        const std::vector<std::size_t>& others = competition.against(r);
        order.competes.push_back(!others.empty());
        std::set<int> sheets{runs[r]->a, runs[r]->b};
        bool is_clear = true;
        for (const std::size_t other : others) {
            sheets.insert({runs[other]->a, runs[other]->b});
            is_clear = is_clear && ranks[r] + clearly_lower < ranks[other];
        }
        order.shows_turned.push_back(is_clear && sheets.size() == 3);
    }
    for (std::size_t r = 0; r < opposed.size(); ++r) {
        opposed[r].turn = longest[competition.group(r)];
        opposed[r].rank = ranks[r];
    }
    return order;
}

}  // namespace ripstop
