#include "ripstop/flatten/weave/woven_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "ripstop/flatten/weave/crossings.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

class Loom {
  public:
    Loom(const UnfoldedSurface& surface, double spacing, int max_nodes, const WovenOptions& options)
        : surface_(surface),
          spacing_(spacing),
          max_nodes_(max_nodes),
          options_(options),
          crossings_(surface, spacing) {}

    void lay_tendons(const SurfacePoint& centre, const Vec2& warp);
    void take_over(const std::vector<WovenNode>& start);
    void fill_quadrants();
    void propagate();
    bool refill();
    void settle();
    WovenFit cut_off();

  private:
    bool is_free(const Site& site) const { return crossings_.is_free(site); }
    int node_at(const Site& site) const { return crossings_.node_at(site); }
    const WovenNode& node(int n) const { return crossings_.node(n); }
    Neighbourhood look(const SurfacePoint& at, const Site& site, double reach) const {
        return crossings_.look(at, site, reach);
    }

    void place(const Site& site, const SurfacePoint& at, bool tendon);
    void open_around(const Site& site);
    double rest_length(std::size_t k) const { return k % 2 == 0 ? std::numbers::sqrt2 * spacing_ : spacing_; }
    double stiffness(std::size_t k) const {
        return k % 2 == 0         ? options_.diagonal_stiffness
               : k == 3 || k == 5 ? options_.weft_stiffness
                                  : options_.warp_stiffness;
    }
    double energy(const Neighbourhood& around) const;
    Vec2 newton_step(const Neighbourhood& around) const;
    bool try_site(const Site& site, const SurfacePoint& from, const Vec2& direction, double length);
    bool place_diagonally(const Site& site);
    bool extend(const Site& site, bool only_straight);

    const UnfoldedSurface& surface_;
    double spacing_;
    int max_nodes_;
    const WovenOptions& options_;
    Crossings crossings_;
    WovenFit fit_;
    // Sites to try, oldest first: across a cell, straight on from a crossing with its three other yarns, from any
    // crossing.
    std::array<std::vector<Site>, 3> open_;
};

void Loom::place(const Site& site, const SurfacePoint& at, bool tendon) {
    crossings_.place(site, at, tendon);
    open_around(site);
    for (const Site& d : structural)
        if (!is_free(site + d))
            for (const Site& e : structural) open_[1].push_back(site + d + e);
}

void Loom::open_around(const Site& site) {
    for (const Site& d : diagonal) open_[0].push_back(site + d);
    for (const Site& d : structural)
        for (auto& list : open_) list.push_back(site + d);
}

double Loom::energy(const Neighbourhood& around) const {
    double sum = 0;
    for (std::size_t k = 0; k < 9; ++k) {
        if (!around.seen[k]) continue;
        const double stretch = around.ray[k].norm() - rest_length(k);
        sum += 0.5 * stiffness(k) * stretch * stretch;
    }
    return sum;
}

/// The Newton step of a crossing between its springs: -H^-1 dE, with the Hessian of each spring made positive
/// semi-definite; at most half a spacing.
Vec2 Loom::newton_step(const Neighbourhood& around) const {
    Mat22 hessian = Mat22::Zero();
    Vec2 pull = Vec2::Zero();
    for (std::size_t k = 0; k < 9; ++k) {
        if (!around.seen[k]) continue;
        const double length = around.ray[k].norm();
        if (length == 0) continue;
        const Vec2 unit = around.ray[k] / length;
        const double slack = std::max(0.0, 1 - rest_length(k) / length);
        hessian += stiffness(k) * ((1 - slack) * unit * unit.transpose() + slack * Mat22::Identity());
        pull += stiffness(k) * (length - rest_length(k)) * unit;
    }
    hessian += 1e-6 * hessian.trace() * Mat22::Identity();
    if (!(hessian.determinant() > 0)) return Vec2::Zero();
    const Vec2 step = hessian.inverse() * pull;
    return step * std::min(1.0, 0.5 * spacing_ / std::max(step.norm(), 1e-300));
}

/// Walks from a crossing to the expected place of `site`, relaxes it between its neighbours, and places it if it
/// stays on the surface, is tied to a neighbour and crowds none.
bool Loom::try_site(const Site& site, const SurfacePoint& from, const Vec2& direction, double length) {
    constexpr int local_steps = 10;
    Walk walk = surface_.walk(from, direction, length);
    if (walk.hit_boundary && length - walk.walked > 1e-9 * spacing_) return false;
    for (int step = 0;; ++step) {
        const Neighbourhood around = look(walk.end, site, woven_reach);
        const bool tied =
            std::any_of(structural.begin(), structural.end(), [&](const Site& d) { return around.sees(d); });
        if (around.is_crowded || !tied) return false;
        const Vec2 move = newton_step(around);
        const double distance = move.norm();
        if (distance < 1e-3 * spacing_ || step == local_steps) {
            place(site, walk.end, false);
            return true;
        }
        walk = surface_.walk(walk.end, move, distance);
        if (walk.hit_boundary && distance - walk.walked > 1e-9 * spacing_) return false;
    }
}

/// Diagonal node mapping: walks from the opposite corner of a cell with three placed corners, between its two sides.
bool Loom::place_diagonally(const Site& site) {
    for (const Site& d : diagonal) {
        const int opposite = node_at(site + d);
        if (opposite < 0 || is_free(site + Site{d.warp, 0}) || is_free(site + Site{0, d.weft})) continue;
        const Neighbourhood around = look(node(opposite).at, site + d, woven_reach);
        const Site along_warp{-d.warp, 0};
        const Site along_weft{0, -d.weft};
        if (!around.sees(along_warp) || !around.sees(along_weft)) continue;
        const Vec2 between = around.to(along_warp).normalized() + around.to(along_weft).normalized();
        if (between.norm() < 0.1) continue;  // the cell is sheared shut
        if (try_site(site, node(opposite).at, between, std::numbers::sqrt2 * spacing_)) return true;
    }
    return false;
}

/// Walks straight on from a neighbour. `only_straight`: from one with its three other yarns in place (principal
/// valence 3), along its own yarn. Otherwise also from one with fewer, in the direction that its neighbours imply
/// together.
bool Loom::extend(const Site& site, bool only_straight) {
    for (const Site& d : structural) {
        const int n = node_at(site + d);
        if (n < 0) continue;
        const Neighbourhood around = look(node(n).at, site + d, woven_reach);
        Vec2 direction = -(around.sees(d) ? around.to(d) : Vec2(Vec2::Zero()));
        const bool both_sides = around.sees({d.weft, d.warp}) && around.sees({-d.weft, -d.warp});
        if (only_straight && !(both_sides && around.sees(d))) continue;
        if (!around.sees(d)) {
            // The rotation from grid to surface: sum of ray / offset over the neighbours as complex numbers.
            Vec2 turn = Vec2::Zero();
            for (std::size_t k = 0; k < 9; ++k) {
                if (!around.seen[k]) continue;
                const Vec2 offset(static_cast<double>(k / 3) - 1, static_cast<double>(k % 3) - 1);
                turn += Vec2(offset.dot(around.ray[k]), cross(offset, around.ray[k]));
            }
            direction = PlaneMotion{turn}.turned(Vec2(-d.warp, -d.weft));
        }
        if (direction.norm() < 1e-6 * spacing_) continue;
        if (try_site(site, node(n).at, direction, spacing_)) return true;
    }
    return false;
}

void Loom::lay_tendons(const SurfacePoint& centre, const Vec2& warp) {
    place({0, 0}, centre, true);
    const std::array<Vec2, 4> directions = {warp, Vec2(-warp.y(), warp.x()), -warp, Vec2(warp.y(), -warp.x())};
    for (std::size_t k = 0; k < 4; ++k) {
        Walk walk{centre, directions[k]};
        for (Site site = structural[k]; crossings_.count() < max_nodes_ / 2; site = site + structural[k]) {
            walk = surface_.walk(walk.end, walk.direction, spacing_);
            if (walk.hit_boundary && spacing_ - walk.walked > 1e-9 * spacing_) break;
            if (look(walk.end, site, crowded).is_crowded) break;  // a straight line may return to where it was
            place(site, walk.end, true);
        }
    }
}

void Loom::take_over(const std::vector<WovenNode>& start) {
    for (const WovenNode& given : start) {
        const Site site{given.warp, given.weft};
        const bool first = crossings_.count() == 0;
        if (!is_free(site) || crossings_.count() >= max_nodes_ / 2) continue;
        const Neighbourhood around = look(given.at, site, woven_reach);
        const bool tied =
            std::any_of(structural.begin(), structural.end(), [&](const Site& d) { return around.sees(d); });
        if (first || (tied && !around.is_crowded)) place(site, given.at, first);
    }
}

void Loom::fill_quadrants() {
    for (const Site& quadrant : diagonal)
        for (int row = 1; !is_free({0, quadrant.weft * row}); ++row)
            for (int column = 1; !is_free({quadrant.warp * column, 0}); ++column) {
                const Site site{quadrant.warp * column, quadrant.weft * row};
                if (crossings_.count() >= max_nodes_) return;
                if (is_free(site)) place_diagonally(site);
            }
}

/// Boundary propagation: cells first, then straight on; each placed crossing opens new sites.
void Loom::propagate() {
    std::array<std::size_t, 3> next = {};
    while (crossings_.count() < max_nodes_) {
        std::size_t kind = 0;
        while (kind < 3 && next[kind] == open_[kind].size()) ++kind;
        if (kind == 3) break;
        const Site site = open_[kind][next[kind]++];
        if (!is_free(site)) continue;
        if (kind == 0)
            place_diagonally(site);
        else
            extend(site, kind == 1);
    }
    for (auto& list : open_) list.clear();
}

/// Tries every free site next to a crossing once more. Returns whether one could be placed.
bool Loom::refill() {
    const int before = crossings_.count();
    for (const WovenNode& n : crossings_.nodes())
        if (n.placed) open_around({n.warp, n.weft});
    propagate();
    return crossings_.count() > before;
}

/// Energy diffusion: relaxes each crossing in turn between its neighbours and drops one that leaves the surface.
void Loom::settle() {
    const double negligible = 1e-20 * options_.warp_stiffness * spacing_ * spacing_ * crossings_.count();
    double previous = std::numeric_limits<double>::infinity();
    while (true) {
        fit_.energy = 0;
        for (int n = 0; n < crossings_.count(); ++n) {
            if (!node(n).placed) continue;
            const Neighbourhood around = look(node(n).at, {node(n).warp, node(n).weft}, woven_reach);
            fit_.energy += 0.5 * energy(around);
            if (node(n).tendon || fit_.iterations >= options_.max_iterations) continue;
            const Vec2 move = newton_step(around);
            if (move.norm() < 1e-12 * spacing_) continue;
            const Walk walk = surface_.walk(node(n).at, move, move.norm());
            if (!walk.hit_boundary || move.norm() - walk.walked <= 1e-9 * spacing_)
                crossings_.move(n, walk.end);
            else
                crossings_.drop(n);
        }
        fit_.at_rest =
            std::abs(previous - fit_.energy) <= options_.energy_tolerance * fit_.energy || fit_.energy <= negligible;
        if (fit_.at_rest || fit_.iterations >= options_.max_iterations) return;
        previous = fit_.energy;
        ++fit_.iterations;
    }
}

WovenFit Loom::cut_off() {
    fit_.spacing = spacing_;
    fit_.nodes = crossings_.nodes();
    return std::move(fit_);
}

}  // namespace

WovenFit fit_woven_mesh(const UnfoldedSurface& surface, const SurfacePoint& centre, const Vec2& warp, double spacing,
                        int max_nodes, const WovenOptions& options) {
    Loom loom(surface, spacing, max_nodes, options);
    loom.lay_tendons(centre, warp.normalized());
    loom.fill_quadrants();
    loom.propagate();
    loom.settle();
    if (loom.refill()) loom.settle();
    return loom.cut_off();
}

WovenFit settle_woven_mesh(const UnfoldedSurface& surface, const std::vector<WovenNode>& start, double spacing,
                           int max_nodes, const WovenOptions& options) {
    Loom loom(surface, spacing, max_nodes, options);
    loom.take_over(start);
    loom.settle();
    if (loom.refill()) loom.settle();
    return loom.cut_off();
}

}  // namespace ripstop
