#include "ripstop/flatten/weave/crossings.h"

#include <cmath>

#include "ripstop/base/index.h"

namespace ripstop {
namespace {

/// A point hidden behind a vertex by less than this sine still counts as visible.
constexpr double barely_hidden = 0.05;

}  // namespace

int Crossings::node_at(const Site& site) const {
    const auto found = site_.find(key(site));
    return found == site_.end() ? -1 : found->second;
}

void Crossings::link(int n) {
    int& head = first_in_[at(node(n).at.triangle)];
    next_in_[at(n)] = head;
    head = n;
}

void Crossings::unlink(int n) {
    int* at = &first_in_[static_cast<std::size_t>(node(n).at.triangle)];
    while (*at != n) at = &next_in_[static_cast<std::size_t>(*at)];
    *at = next_in_[static_cast<std::size_t>(n)];
}

void Crossings::place(const Site& site, const SurfacePoint& at, bool tendon) {
    const int n = count();
    nodes_.push_back({at, site.warp, site.weft, tendon});
    next_in_.push_back(-1);
    link(n);
    site_.emplace(key(site), n);
}

void Crossings::move(int n, const SurfacePoint& to) {
    unlink(n);
    nodes_[at(n)].at = to;
    link(n);
}

void Crossings::drop(int n) {
    unlink(n);
    nodes_[at(n)].placed = false;
    site_.erase(key({node(n).warp, node(n).weft}));
}

Neighbourhood Crossings::look(const SurfacePoint& at, const Site& site, double reach) const {
    Neighbourhood around;
    std::array<double, 9> hidden;
    hidden.fill(barely_hidden);
    for (const Sight& sight : surface_.look_around(at, reach * spacing_))
        for (int n = first_in_[static_cast<std::size_t>(sight.triangle)]; n >= 0;
             n = next_in_[static_cast<std::size_t>(n)]) {
            const Site offset{node(n).warp - site.warp, node(n).weft - site.weft};
            if (offset.warp == 0 && offset.weft == 0) continue;
            const Vec2 point = sight.unfolded(node(n).at.local);
            const Vec2 ray = point - at.local;
            if (ray.squaredNorm() < crowded * crowded * spacing_ * spacing_) around.is_crowded = true;
            if (!Neighbourhood::is_around(offset)) continue;
            const std::size_t k = Neighbourhood::index(offset);
            const double behind = sight.hidden_by(point);
            const bool nearer = around.seen[k] && behind == hidden[k] && ray.norm() < around.ray[k].norm();
            if (!(behind < hidden[k] || nearer) || ray.norm() > reach * spacing_) continue;
            hidden[k] = behind;
            around.seen[k] = true;
            around.ray[k] = ray;
        }
    return around;
}

}  // namespace ripstop
