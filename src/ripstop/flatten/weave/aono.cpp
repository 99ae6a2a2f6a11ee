#include "ripstop/flatten/weave/aono.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/flatten/weave/crossings.h"
#include "ripstop/flatten/weave/weave_frame.h"
#include "ripstop/flatten/weave/weave_reading.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

/// A crossing that cannot be placed because its two threads nearly coincide.
struct Lock {
    Site site;
    SurfacePoint beside;
};

class Net {
  public:
    Net(const UnfoldedSurface& surface, const WeaveFrame& frame, int most, double smallest_angle)
        : surface_(surface),
          spacing_(frame.spacing),
          most_(most),
          smallest_sine_(std::sin(smallest_angle)),
          crossings_(surface, frame.spacing) {
        lay_lines(frame);
        sweep();
    }

    WovenFit fit() const { return {spacing_, crossings_.nodes(), 0, true, 0}; }
    std::vector<Lock> locks() const;  ///< in order of discovery, each site once

  private:
    void lay_lines(const WeaveFrame& frame);
    void sweep();
    void place(const Site& site, const SurfacePoint& at, bool line);
    bool close_cell(const Site& corner, const Site& across);
    bool lead_on(const Site& site);
    std::optional<SurfacePoint> walk(const SurfacePoint& from, const Vec2& way) const;
    std::optional<Vec2> meet(const Vec2& a, const Vec2& b) const;

    const UnfoldedSurface& surface_;
    double spacing_;
    int most_;
    double smallest_sine_;
    Crossings crossings_;
    std::vector<Site> open_;  ///< crossings round which cells may still be closed, oldest first
    std::vector<Lock> locks_;
};

/// The end of a straight walk; empty if the boundary comes first.
std::optional<SurfacePoint> Net::walk(const SurfacePoint& from, const Vec2& way) const {
    if (way.norm() < 1e-12 * spacing_) return from;
    const Walk walk = surface_.walk(from, way, way.norm());
    if (walk.hit_boundary && way.norm() - walk.walked > 1e-9 * spacing_) return {};
    return walk.end;
}

void Net::place(const Site& site, const SurfacePoint& at, bool line) {
    crossings_.place(site, at, line);
    open_.push_back(site);
}

std::vector<Lock> Net::locks() const {
    std::vector<Lock> open;
    std::set<std::pair<int, int>> seen;
    for (const Lock& lock : locks_)  // another cell may have reached the site since
        if (crossings_.is_free(lock.site) && seen.emplace(lock.site.warp, lock.site.weft).second) open.push_back(lock);
    return open;
}

/// The intersection of the circles of radius `spacing` round a and b that is nearer to the origin.
std::optional<Vec2> Net::meet(const Vec2& a, const Vec2& b) const {
    const Vec2 half = 0.5 * (b - a);
    const double rest = spacing_ * spacing_ - half.squaredNorm();
    if (half.norm() < smallest_sine_ / 2 * spacing_ || rest < 0) return {};
    const Vec2 up = std::sqrt(rest) * Vec2(-half.y(), half.x()).normalized();
    const Vec2 one = a + half + up, other = a + half - up;
    return one.norm() < other.norm() ? one : other;
}

/// Places the fourth crossing of a cell whose other three are in place, opposite `corner`.
bool Net::close_cell(const Site& corner, const Site& across) {
    const Site site = corner + across;
    const int n = crossings_.node_at(corner);
    if (!crossings_.is_free(site) || crossings_.is_free(corner + Site{across.warp, 0}) ||
        crossings_.is_free(corner + Site{0, across.weft}))
        return false;
    const SurfacePoint from = crossings_.node(n).at;
    const Neighbourhood cell = crossings_.look(from, corner, woven_reach);
    const Site along_warp{across.warp, 0}, along_weft{0, across.weft};
    if (!cell.sees(along_warp) || !cell.sees(along_weft)) return false;
    const Vec2 warp = cell.to(along_warp), weft = cell.to(along_weft);
    const double turn = across.warp * across.weft;
    if (turn * cross(warp, weft) < smallest_sine_ * warp.norm() * weft.norm()) {
        locks_.push_back({site, from});
        return false;
    }
    std::optional<SurfacePoint> at = walk(from, warp + weft);
    constexpr int most_steps = 20;
    for (int step = 0; at && step < most_steps; ++step) {
        const Neighbourhood around = crossings_.look(*at, site, woven_reach);
        const Site back_warp{-across.warp, 0}, back_weft{0, -across.weft};
        if (around.is_crowded) {
            // crowded by its own neighbours: the cell is nearly shut; by others: two fronts of the net meet here
            const auto shut = [&](const Site& d) { return around.sees(d) && around.to(d).norm() < crowded * spacing_; };
            if (std::any_of(diagonal.begin(), diagonal.end(), shut)) locks_.push_back({site, *at});
            return false;
        }
        if (!around.sees(back_warp) || !around.sees(back_weft)) return false;
        const std::optional<Vec2> move = meet(around.to(back_warp), around.to(back_weft));
        if (!move) {
            locks_.push_back({site, *at});
            return false;
        }
        at = walk(*at, *move);
        if (at && move->norm() < 1e-10 * spacing_) break;
    }
    if (!at) return false;
    place(site, *at, false);
    return true;
}

/// Extends a thread straight on from its last two crossings.
bool Net::lead_on(const Site& site) {
    const SurfacePoint from = crossings_.node(crossings_.node_at(site)).at;
    const Neighbourhood around = crossings_.look(from, site, woven_reach);
    for (const Site& d : structural) {
        const Site back{-d.warp, -d.weft};
        if (!crossings_.is_free(site + d) || !around.sees(back)) continue;
        const std::optional<SurfacePoint> at = walk(from, -spacing_ * around.to(back).normalized());
        if (!at || crossings_.look(*at, site + d, crowded).is_crowded) continue;
        place(site + d, *at, false);
        return true;
    }
    return false;
}

void Net::lay_lines(const WeaveFrame& frame) {
    place({0, 0}, frame.centre, true);
    const Vec2 across(-frame.warp.y(), frame.warp.x());
    for (std::size_t k = 0; k < structural.size(); ++k) {
        Walk walk{frame.centre, structural[k].warp * frame.warp + structural[k].weft * across};
        for (Site site = structural[k]; crossings_.count() < most_ / 2; site = site + structural[k]) {
            walk = surface_.walk(walk.end, walk.direction, spacing_);
            if (walk.hit_boundary && spacing_ - walk.walked > 1e-9 * spacing_) break;
            // a straight line may return to where it was
            if (crossings_.look(walk.end, site, crowded).is_crowded) break;
            place(site, walk.end, true);
        }
    }
}

/// Closes cells round each crossing, in order of placement; extends threads where no cell can be closed.
void Net::sweep() {
    std::size_t closed = 0, led = 0;
    while (crossings_.count() < most_) {
        if (closed < open_.size()) {
            const Site site = open_[closed++];
            for (const Site& round : {Site{0, 0}, Site{1, 0}, Site{0, 1}, Site{-1, 0}, Site{0, -1}}) {
                if (crossings_.is_free(site + round)) continue;
                for (const Site& d : diagonal) close_cell(site + round, d);
            }
        } else if (led < open_.size()) {
            if (!lead_on(open_[led])) ++led;
        } else {
            return;
        }
    }
}

}  // namespace

Flattening flatten_aono(const Tile& tile, const AonoOptions& options) {
    if (!(options.spacing > 0) || !std::isfinite(options.spacing) ||
        !(options.smallest_angle > 0 && options.smallest_angle < 1.5))
        throw InputError("the net of inextensible threads: the spacing is " + format_shortest(options.spacing) +
                         " and the smallest angle " + format_shortest(options.smallest_angle) +
                         ", expected a positive number and one between 0 and 1.5");
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    const UnfoldedSurface surface(tile.mesh);
    const WeaveFrame frame = make_weave_frame(tile, adjacency, surface, options.spacing);
    const Net net(surface, frame, most_crossings(tile), options.smallest_angle);
    const WovenFit fit = net.fit();
    std::string reason = std::to_string(count_crossings(fit)) + " crossings";
    const std::vector<Lock> locks = net.locks();
    if (!locks.empty()) {
        const Vec3 at = surface.position(locks.front().beside);
        reason += ", the net breaks down: threads coincide, first at (" + format_fixed(at.x(), 3) + ", " +
                  format_fixed(at.y(), 3) + ", " + format_fixed(at.z(), 3) + ") m; " + std::to_string(locks.size()) +
                  " crossings could not be placed";
    }
    return read_weave(tile, adjacency, surface, fit, frame.centre.triangle,
                      !locks.empty() ? Termination::stagnated : Termination::converged, reason);
}

}  // namespace ripstop
