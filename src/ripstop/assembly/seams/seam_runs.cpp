#include "ripstop/assembly/seams/seam_runs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"

namespace ripstop {
namespace {

/// The tolerance as a share of the edge at a place: places closer than this coincide.
double blur(const ChainCurve& curve, double at, double tolerance) {
    const int edge = std::clamp(static_cast<int>(at), 0, curve.edge_count() - 1);
    return std::min(0.25, tolerance / chord_of_edge(curve, edge));
}

/// True if a vertex lies between two places, more than `blur` from both.
bool vertex_between(double low, double high, double blur) {
    return std::ceil(low + blur) < high - blur;
}

struct Joiner {
    const ChainCurve& a;
    const ChainCurve& b;
    double tolerance;

    bool follows(const Touch& p, const Touch& q, double q_at_b) const {
        const double blur_a = blur(a, p.at_a, tolerance), blur_b = blur(b, p.at_b, tolerance);
        if (vertex_between(p.at_a, q.at_a, blur_a)) return false;
        const double ahead = p.same_way ? q_at_b - p.at_b : p.at_b - q_at_b;
        if (ahead < -2 * blur_b || ahead > 1 + 2 * blur_b) return false;
        return !vertex_between(std::min(p.at_b, q_at_b), std::max(p.at_b, q_at_b), blur_b);
    }
};

void measure(Run& run, const ChainCurve& a, const ChainCurve& b) {
    run.low_b = run.high_b = run.touches.front().at_b;
    run.gap = 0;
    for (const Touch& touch : run.touches) {
        run.low_b = std::min(run.low_b, touch.at_b);
        run.high_b = std::max(run.high_b, touch.at_b);
        run.gap = std::max(run.gap, touch.distance);
    }
    run.length = std::min(station_at(a, run.end_a()) - station_at(a, run.start_a()),
                          station_at(b, run.high_b) - station_at(b, run.low_b));
}

/// Appends `next` to `run` if it continues it, also across the start of a loop.
bool append(Run& run, const Run& next, const Joiner& join) {
    const double lap_a = join.a.closed ? join.a.edge_count() : 0, lap_b = join.b.closed ? join.b.edge_count() : 0;
    const Touch& tail = run.touches.back();
    for (const double turn_a : {0.0, lap_a})
        for (const double turn_b : {0.0, lap_b, -lap_b}) {
            Touch head = next.touches.front();
            head.at_a += turn_a;
            const double gained = head.at_a - tail.at_a;
            if (gained < -1e-9 || gained > 1) continue;
            if (next.touches.back().at_a + turn_a - run.start_a() > join.a.edge_count() + 1e-9) continue;
            if (!join.follows(tail, head, head.at_b + turn_b)) continue;
            for (Touch touch : next.touches) {
                touch.at_a += turn_a;
                touch.at_b += turn_b;
                run.touches.push_back(touch);
            }
            return true;
        }
    return false;
}

/// A loop has no ends, so runs that its start separates are joined.
void join_over_starts(std::vector<Run>& runs, const Joiner& join) {
    if (!join.a.closed && !join.b.closed) return;
    for (bool joined = true; joined;) {
        joined = false;
        for (std::size_t i = 0; i < runs.size() && !joined; ++i)
            for (std::size_t j = 0; j < runs.size() && !joined; ++j) {
                if (i == j || !append(runs[i], runs[j], join)) continue;
                runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(j));
                joined = true;
            }
    }
}

}  // namespace

std::vector<PlacedChain> place_chains(const std::vector<Tile>& tiles) {
    std::vector<std::vector<PlacedChain>> found(tiles.size());
    parallel_for(static_cast<int>(tiles.size()), 0, [&](int t) {
        const Tile& tile = tiles[at(t)];
        const auto begin = tile.boundary.begin();
        const int count = static_cast<int>(tile.boundary.size());
        int first = 0;
        for (int c = 0; c < static_cast<int>(tile.chains.size()); ++c) {
            const Chain& chain = tile.chains[at(c)];
            if (c == 0) first = static_cast<int>(std::find(begin, tile.boundary.end(), chain.vertices.front()) - begin);
            found[at(t)].push_back({t, c, first, count, make_chain_curve(tile, chain)});
            first = (first + chain.edge_count()) % count;
        }
    });
    std::vector<PlacedChain> chains;
    for (std::vector<PlacedChain>& some : found)
        for (PlacedChain& chain : some) chains.push_back(std::move(chain));
    return chains;
}

std::vector<Run> join_touches(const std::vector<PlacedChain>& chains, std::vector<Touch> touches, double tolerance) {
    if (touches.size() < 2) return {};
    const Joiner join{chains[at(touches.front().a)].curve, chains[at(touches.front().b)].curve, tolerance};
    std::vector<Run> runs;
    std::vector<std::size_t> open;
    for (const Touch& touch : touches) {
        std::erase_if(open, [&](std::size_t r) {
            const double tail = runs[r].touches.back().at_a;
            return vertex_between(tail, touch.at_a, blur(join.a, tail, tolerance));
        });
        std::optional<std::size_t> best;
        for (const std::size_t r : open) {
            const Touch& tail = runs[r].touches.back();
            if (!join.follows(tail, touch, touch.at_b)) continue;
            if (!best || std::abs(tail.at_b - touch.at_b) < std::abs(runs[*best].touches.back().at_b - touch.at_b))
                best = r;
        }
        if (!best) {
            best = runs.size();
            open.push_back(*best);
            runs.push_back({touch.a, touch.b, touch.same_way, {}});
        }
        runs[*best].touches.push_back(touch);
    }
    join_over_starts(runs, join);
    for (Run& run : runs) measure(run, join.a, join.b);
    std::erase_if(runs, [](const Run& run) { return !(run.length > 0); });
    return runs;
}

std::optional<Run> cut_run(const std::vector<PlacedChain>& chains, const Run& run, bool by_b, double low, double high) {
    const auto key = [&](const Touch& touch) { return by_b ? touch.at_b : touch.at_a; };
    Run part{run.a, run.b, run.same_way, {}};
    const auto add_between = [&](const Touch& p, const Touch& q, double bound) {
        if ((key(p) < bound) == (key(q) < bound) || key(p) == bound || key(q) == bound) return;
        const double share = (bound - key(p)) / (key(q) - key(p));
        Touch touch = p;
        touch.at_a += share * (q.at_a - p.at_a);
        touch.at_b += share * (q.at_b - p.at_b);
        (by_b ? touch.at_b : touch.at_a) = bound;
        touch.distance = std::max(p.distance, q.distance);
        part.touches.push_back(touch);
    };
    for (std::size_t i = 0; i < run.touches.size(); ++i) {
        const Touch& touch = run.touches[i];
        if (i > 0) {
            const Touch& before = run.touches[i - 1];
            const bool rises = key(before) < key(touch);
            add_between(before, touch, rises ? low : high);
            add_between(before, touch, rises ? high : low);
        }
        if (key(touch) >= low && key(touch) <= high) part.touches.push_back(touch);
    }
    if (part.touches.size() < 2) return {};
    measure(part, chains[at(run.a)].curve, chains[at(run.b)].curve);
    return part;
}

Run seen_from_b(const Run& run) {
    Run other = run;
    std::swap(other.a, other.b);
    for (Touch& touch : other.touches) {
        std::swap(touch.a, touch.b);
        std::swap(touch.at_a, touch.at_b);
    }
    if (!run.same_way) std::reverse(other.touches.begin(), other.touches.end());
    other.low_b = run.start_a();
    other.high_b = run.end_a();
    return other;
}

}  // namespace ripstop
