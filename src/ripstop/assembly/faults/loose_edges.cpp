#include "ripstop/assembly/faults/loose_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "ripstop/base/index.h"
#include "ripstop/mesh/boundary.h"

namespace ripstop {
namespace {

constexpr double loose_corner_turn = 40 * degree;

double turn_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A loose run and its place in space.
struct PlacedRun {
    const LooseRun* run;
    BoundaryCurve curve;
    double length;
    bool closed;
    Vec3 start, end;
};

/// Corners, area vector and centre of a loop, accumulated run by run.
struct LoopSums {
    Vec3 area = Vec3::Zero(), moment = Vec3::Zero();
    std::vector<Vec3> corners = {};
    double length = 0;

    void add_step(const Vec3& from, const Vec3& to) {
        const double step = (to - from).norm();
        area += from.cross(to) / 2;
        moment += step * (from + to) / 2;
        length += step;
    }
    void add(const PlacedRun& placed) {
        Vec3 from = placed.start;
        for (double at = std::floor(placed.run->start) + 1; at < placed.run->end; ++at) {
            const Vec3 to = placed.curve.point(at);
            add_step(from, to);
            from = to;
            if (turn_between(placed.curve.direction_before(at), placed.curve.direction_after(at)) > loose_corner_turn)
                corners.push_back(to);
        }
        add_step(from, placed.end);
    }
};

LooseLoop make_loop(const std::vector<Tile>& tiles, const std::vector<PlacedRun>& runs, const std::vector<int>& members,
                    bool closed, std::vector<std::vector<Vec3>>* corners_of_loop) {
    LooseLoop loop;
    LoopSums sums;
    Vec3 outward = Vec3::Zero();
    for (std::size_t i = 0; i < members.size(); ++i) {
        const PlacedRun& run = runs[at(members[i])];
        const PlacedRun& next = runs[at(members[(i + 1) % members.size()])];
        loop.tiles.push_back(run.run->tile);
        outward += area_vector(tiles[at(run.run->tile)].mesh);
        sums.add(run);
        if (i + 1 == members.size() && !closed) continue;
        sums.add_step(run.end, next.start);
        if (turn_between(run.curve.direction_before(run.run->end), next.curve.direction_after(next.run->start)) >
            loose_corner_turn)
            sums.corners.push_back(run.end);
    }
    loop.closed = closed;
    loop.length = sums.length;
    loop.corners = static_cast<int>(sums.corners.size());
    loop.centre = sums.length > 0 ? Vec3(sums.moment / sums.length) : runs[0].start;
    loop.openness = sums.length > 0 ? sums.area.norm() / (sums.length * sums.length) : 0;
    loop.outline = sums.area.dot(outward) > 0;
    if (corners_of_loop) corners_of_loop->push_back(std::move(sums.corners));
    return loop;
}

/// The free run that starts nearest to the end of `from`; -1 if none is near.
int nearest_start(const std::vector<PlacedRun>& runs, const std::vector<bool>& taken, int from, double tolerance) {
    const PlacedRun& run = runs[at(from)];
    int best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int r = 0; r < static_cast<int>(runs.size()); ++r) {
        const PlacedRun& other = runs[at(r)];
        if (other.closed || taken[at(r)]) continue;
        const double reach = std::max(20 * tolerance, 0.05 * std::max(run.length, other.length));
        const double distance = (other.start - run.end).norm();
        if (distance > reach || !(distance < nearest)) continue;
        nearest = distance;
        best = r;
    }
    return best;
}

}  // namespace

BoundaryCurve::BoundaryCurve(const std::vector<PlacedChain>& chains, int tile) : edges_(0) {
    auto first = std::lower_bound(chains.begin(), chains.end(), tile,
                                  [](const PlacedChain& chain, int t) { return chain.tile < t; });
    for (; first != chains.end() && first->tile == tile; ++first) {
        chains_.push_back(&*first);
        edges_ = first->boundary_edges;
    }
}

const PlacedChain& BoundaryCurve::chain_at(int boundary_edge, int& local) const {
    const PlacedChain* found = chains_.front();
    for (const PlacedChain* chain : chains_) {
        local = ((boundary_edge - chain->first_edge) % edges_ + edges_) % edges_;
        if (local < chain->curve.edge_count()) return *chain;
        found = chain;
    }
    return *found;
}

std::pair<const ChainCurve*, int> BoundaryCurve::edge(int boundary_edge) const {
    int local = 0;
    const PlacedChain& chain = chain_at(boundary_edge, local);
    return {&chain.curve, local};
}

Vec3 BoundaryCurve::point(double at) const {
    const auto [curve, local] = edge(static_cast<int>(std::floor(at)));
    return point_at(*curve, local + (at - std::floor(at)));
}

Vec3 BoundaryCurve::direction_after(double at) const {
    const auto [curve, local] = edge(static_cast<int>(std::floor(at)));
    if (at == std::floor(at)) return Vec3(curve->start_slopes.row(local)).normalized();
    return direction_at(*curve, local + (at - std::floor(at)));
}

Vec3 BoundaryCurve::direction_before(double at) const {
    if (at != std::floor(at)) return direction_after(at);
    const auto [curve, local] = edge(static_cast<int>(at) - 1 + edges_);
    return Vec3(curve->end_slopes.row(local)).normalized();
}

double BoundaryCurve::length_between(double start, double end) const {
    double sum = 0;
    Vec3 from = point(start);
    for (double at = std::floor(start) + 1; at < end; ++at) {
        const Vec3 to = point(at);
        sum += (to - from).norm();
        from = to;
    }
    return sum + (point(end) - from).norm();
}

std::vector<LooseLoop> find_loops(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains,
                                  const std::vector<LooseRun>& loose, double tolerance,
                                  std::vector<std::vector<int>>* runs_of_loop,
                                  std::vector<std::vector<Vec3>>* corners_of_loop) {
    std::vector<PlacedRun> runs;
    for (const LooseRun& run : loose) {
        const BoundaryCurve curve(chains, run.tile);
        const bool closed = run.end - run.start >= curve.edge_count();
        runs.push_back({&run, curve, curve.length_between(run.start, run.end), closed, curve.point(run.start),
                        curve.point(run.end)});
    }
    std::vector<LooseLoop> loops;
    std::vector<bool> taken(runs.size(), false);
    const auto keep = [&](const std::vector<int>& members, bool closed) {
        loops.push_back(make_loop(tiles, runs, members, closed, corners_of_loop));
        if (runs_of_loop) runs_of_loop->push_back(members);
    };
    for (int first = 0; first < static_cast<int>(runs.size()); ++first) {
        if (taken[at(first)]) continue;
        if (runs[at(first)].closed) {
            keep({first}, true);
            continue;
        }
        std::vector<int> members{first};
        int next = nearest_start(runs, taken, first, tolerance);
        while (next >= 0 && next != first) {
            taken[at(next)] = true;
            members.push_back(next);
            next = nearest_start(runs, taken, next, tolerance);
        }
        taken[at(first)] = true;
        keep(members, next == first);
    }
    return loops;
}

double turn_on_cloth(const std::vector<Tile>& tiles, const Vec3& place, double reach) {
    double turn = std::numbers::pi;
    for (const Tile& tile : tiles) {
        const std::size_t count = tile.boundary.size();
        std::vector<bool> is_near(count);
        for (std::size_t i = 0; i < count; ++i)
            is_near[i] = (Vec3(tile.mesh.positions.row(tile.boundary[i])) - place).norm() < reach;
        const bool has_corner = std::find(is_near.begin(), is_near.end(), true) != is_near.end();
        const Eigen::VectorXd turning =
            has_corner ? surface_turning(tile.mesh, tile.boundary) : Eigen::VectorXd(Eigen::VectorXd::Zero(0));
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t next = (i + 1) % count;
            if (is_near[i]) turn += turning[static_cast<Eigen::Index>(i)];
            if (is_near[i] && !is_near[next]) turn -= std::numbers::pi;
            if (is_near[i] || is_near[next]) continue;
            const Vec3 from = tile.mesh.positions.row(tile.boundary[i]);
            const Vec3 along = Vec3(tile.mesh.positions.row(tile.boundary[next])) - from;
            const double share = std::clamp((place - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
            if ((from + share * along - place).norm() < reach) turn -= std::numbers::pi;
        }
    }
    return turn;
}

}  // namespace ripstop
