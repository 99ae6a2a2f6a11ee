#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ripstop/flatten/weave/woven_fit.h"

namespace ripstop {

/// A position in the weave, in steps from its centre.
struct Site {
    int warp = 0, weft = 0;
};
inline Site operator+(const Site& a, const Site& b) {
    return {a.warp + b.warp, a.weft + b.weft};
}

inline constexpr std::array<Site, 4> structural = {Site{1, 0}, Site{0, 1}, Site{-1, 0}, Site{0, -1}};
inline constexpr std::array<Site, 4> diagonal = {Site{1, 1}, Site{-1, 1}, Site{-1, -1}, Site{1, -1}};

/// A crossing closer than this to one that is not a neighbour would cover the surface twice [spacings].
inline constexpr double crowded = 0.5;

/// The visible crossings around a crossing: `ray[k]` leads to the neighbour at site (k / 3 - 1, k % 3 - 1).
struct Neighbourhood {
    std::array<Vec2, 9> ray;
    std::array<bool, 9> seen = {};
    bool is_crowded = false;

    static std::size_t index(const Site& offset) {
        return static_cast<std::size_t>(3 * (offset.warp + 1) + offset.weft + 1);
    }
    bool sees(const Site& offset) const { return seen[index(offset)]; }
    const Vec2& to(const Site& offset) const { return ray[index(offset)]; }
    static bool is_around(const Site& offset) { return std::abs(offset.warp) <= 1 && std::abs(offset.weft) <= 1; }
};

/// The crossings of a weave on a surface, indexed by number, site and triangle.
class Crossings {
  public:
    Crossings(const UnfoldedSurface& surface, double spacing)
        : surface_(surface), spacing_(spacing), first_in_(static_cast<std::size_t>(surface.triangle_count()), -1) {}

    const std::vector<WovenNode>& nodes() const { return nodes_; }
    int count() const { return static_cast<int>(nodes_.size()); }
    const WovenNode& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
    bool is_free(const Site& site) const { return node_at(site) < 0; }
    int node_at(const Site& site) const;  ///< -1 if free

    void place(const Site& site, const SurfacePoint& at, bool tendon);
    void move(int n, const SurfacePoint& to);
    void drop(int n);  ///< removes a crossing that left the surface; its site is free again

    /// The crossings within `reach` spacings that are visible from `at`, as seen by the crossing of `site`.
    Neighbourhood look(const SurfacePoint& at, const Site& site, double reach) const;

  private:
    void link(int n);
    void unlink(int n);
    static std::int64_t key(const Site& site) { return (std::int64_t{site.warp} << 32) + site.weft; }

    const UnfoldedSurface& surface_;
    double spacing_;
    std::vector<WovenNode> nodes_;
    std::unordered_map<std::int64_t, int> site_;  // for look-up only, never iterated
    std::vector<int> first_in_;                   // the nodes of each triangle as linked lists
    std::vector<int> next_in_;
};

}  // namespace ripstop
