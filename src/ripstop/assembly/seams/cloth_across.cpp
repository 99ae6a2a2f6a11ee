#include "ripstop/assembly/seams/cloth_across.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"

namespace ripstop {
namespace {

constexpr double longest_way = 2;  // times the distance
constexpr double off_place = 0.5;  // times the distance: how far from the other place a walk may end on its chain
constexpr int most_seams = 8;      // seams that a walk may cross

}  // namespace

/// The plane of a walk. Vertices in the plane count as being on one fixed side, so a walk is always unique.
struct ClothAcross::WalkPlane {
    Vec3 origin, normal;
    bool zero_is_left = false;

    double height(const Vec3& point) const { return normal.dot(point - origin); }
    bool is_left(const Vec3& point) const { return zero_is_left ? height(point) >= 0 : height(point) > 0; }
    Vec3 crossing(const Vec3& p, const Vec3& q) const {
        const double a = height(p), b = height(q);
        return a == b ? p : Vec3(p + a / (a - b) * (q - p));
    }
};

struct ClothAcross::Surface {
    const Tile& tile;
    Adjacency adjacency;
    double width;
    std::vector<int> edge_of_vertex;       ///< the boundary edge that starts there; -1: none
    std::vector<int> half_edge_of_vertex;  ///< the same as a half-edge

    explicit Surface(const Tile& of)
        : tile(of),
          adjacency(of.mesh.triangles, of.mesh.vertex_count()),
          width(2 * surface_area(of.mesh) / edge_lengths(of.mesh.positions, closed(of.boundary)).sum()),
          edge_of_vertex(static_cast<std::size_t>(of.mesh.vertex_count()), -1),
          half_edge_of_vertex(edge_of_vertex) {
        for (std::size_t k = 0; k < tile.boundary.size(); ++k)
            edge_of_vertex[static_cast<std::size_t>(tile.boundary[k])] = static_cast<int>(k);
        for (int h = 0; h < adjacency.half_edge_count(); ++h)
            if (adjacency.is_boundary(h)) half_edge_of_vertex[static_cast<std::size_t>(adjacency.from(h))] = h;
    }
    Vec3 at(int vertex) const { return tile.mesh.positions.row(vertex); }
    Vec3 from(int h) const { return at(adjacency.from(h)); }
    Vec3 to(int h) const { return at(adjacency.to(h)); }
    int boundary_edge(int h) const { return edge_of_vertex[static_cast<std::size_t>(adjacency.from(h))]; }
    int half_edge(int boundary_edge) const {
        return half_edge_of_vertex[static_cast<std::size_t>(tile.boundary[static_cast<std::size_t>(boundary_edge)])];
    }
    Vec3 area_of(int triangle) const {
        const TriangleMesh& mesh = tile.mesh;
        const Vec3 a = mesh.corner(triangle, 0);
        return (mesh.corner(triangle, 1) - a).cross(mesh.corner(triangle, 2) - a);
    }
    bool crosses(const WalkPlane& plane, int h) const { return plane.is_left(from(h)) != plane.is_left(to(h)); }

    /// Continues from a half-edge through its triangle and the next ones. Returns the boundary half-edge it
    /// reaches, or -1 if the walk becomes too long.
    int go_on(const WalkPlane& plane, int h, WalkState& walk) const;
};

struct ClothAcross::WalkState {
    const Surface* on;
    Vec3 at;
    double left;  ///< remaining length [m]

    bool go_to(const Vec3& there) {
        left -= (there - at).norm();
        at = there;
        return left >= 0;
    }
};

int ClothAcross::Surface::go_on(const WalkPlane& plane, int h, WalkState& walk) const {
    for (int step = 0; step < tile.mesh.triangle_count(); ++step) {  // a walk around a vertex would not end
        const int next = Adjacency::next(h), exit = crosses(plane, next) ? next : Adjacency::previous(h);
        if (!walk.go_to(plane.crossing(from(exit), to(exit)))) return -1;
        if (adjacency.is_boundary(exit)) return exit;
        h = adjacency.twin(exit);
    }
    return -1;
}

/// A place on a boundary, on the mesh: straight edges replace the chain's curve.
struct ClothAcross::WalkEnd {
    int tile, chain, edge;  ///< index of the edge in the boundary
    int vertex;             ///< -1: inside the edge
    Vec3 point;
};

ClothAcross::ClothAcross(const std::vector<Tile>& tiles, const std::vector<PlacedChain>& chains)
    : tiles_(tiles), chains_(chains) {}
ClothAcross::~ClothAcross() = default;

void ClothAcross::cross(const std::vector<Seam>& seams) {
    mates_.clear();
    for (const Seam& seam : seams)
        for (const auto& [side, mate] : {std::pair(&seam.a, &seam.b), std::pair(&seam.b, &seam.a)})
            for (const SeamPart& part : side->parts) mates_[{side->tile, part.edge}].push_back(mate);
}

bool ClothAcross::in_one_tile(const Touch& touch) const {
    return chains_[static_cast<std::size_t>(touch.a)].tile == chains_[static_cast<std::size_t>(touch.b)].tile;
}

double ClothAcross::width_at(int chain) const {
    return surface(chains_[static_cast<std::size_t>(chain)].tile).width;
}

const ClothAcross::Surface& ClothAcross::surface(int tile) const {
    std::unique_ptr<Surface>& known = surfaces_[tile];
    if (!known) known = std::make_unique<Surface>(tiles_[static_cast<std::size_t>(tile)]);
    return *known;
}

ClothAcross::WalkEnd ClothAcross::place_on(int chain, double at) const {
    const PlacedChain& placed = chains_[static_cast<std::size_t>(chain)];
    const Tile& tile = tiles_[static_cast<std::size_t>(placed.tile)];
    const int local = static_cast<int>(std::floor(at));
    const auto vertex = [&](int k) {
        return tile.boundary[static_cast<std::size_t>((placed.first_edge + k) % placed.boundary_edges)];
    };
    const Vec3 start = tile.mesh.positions.row(vertex(local));
    WalkEnd place{placed.tile, chain, (placed.first_edge + local) % placed.boundary_edges, -1, start};
    if (at == local)
        place.vertex = vertex(local);
    else
        place.point += (at - local) * (Vec3(tile.mesh.positions.row(vertex(local + 1))) - start);
    return place;
}

/// Starts a walk at a place on the boundary, across its tile. Returns the boundary half-edge it reaches, or -1.
int ClothAcross::set_out(const WalkPlane& plane, const WalkEnd& from, WalkState& walk) const {
    const Surface& on = *walk.on;
    if (from.vertex < 0) {
        const int h = on.half_edge(from.edge);
        return on.crosses(plane, h) ? on.go_on(plane, h, walk) : -1;
    }
    for (const int h : on.adjacency.outgoing(from.vertex)) {
        const int opposite = Adjacency::next(h);
        if (!on.crosses(plane, opposite)) continue;
        if (!walk.go_to(plane.crossing(on.from(opposite), on.to(opposite)))) return -1;
        return on.adjacency.is_boundary(opposite) ? opposite : on.go_on(plane, on.adjacency.twin(opposite), walk);
    }
    return -1;
}

/// Continues a walk across the seam on a boundary edge, over the tile beyond. Returns as `set_out` does.
int ClothAcross::cross_seam(const WalkPlane& plane, int edge, double reach, WalkState& walk) const {
    const auto mates = mates_.find({static_cast<int>(&walk.on->tile - tiles_.data()), edge});
    if (mates == mates_.end()) return -1;
    double nearest = reach;
    const Surface* beyond = nullptr;
    int into = -1;
    for (const SeamSide* mate : mates->second)
        for (const SeamPart& part : mate->parts) {
            const Surface& there = surface(mate->tile);
            const int h = there.half_edge(part.edge);
            if (h < 0 || !there.crosses(plane, h)) continue;
            const double off = (plane.crossing(there.from(h), there.to(h)) - walk.at).norm();
            if (off > nearest) continue;
            nearest = off;
            beyond = &there;
            into = h;
        }
    if (!beyond) return -1;
    walk.on = beyond;
    return beyond->go_on(plane, into, walk);
}

bool ClothAcross::walk_arrives(const WalkEnd& from, const WalkEnd& to, bool zero_is_left) const {
    WalkState walk{&surface(from.tile), from.point, longest_way * (to.point - from.point).norm()};
    const double reach = off_place / longest_way * walk.left;
    Vec3 normal = Vec3::Zero();
    if (from.vertex < 0) normal = walk.on->area_of(Adjacency::triangle(walk.on->half_edge(from.edge)));
    if (from.vertex >= 0)
        for (const int h : walk.on->adjacency.outgoing(from.vertex)) normal += walk.on->area_of(Adjacency::triangle(h));
    const Vec3 upright = (to.point - from.point).cross(normal);
    if (!(upright.norm() > 1e-9 * (to.point - from.point).norm() * normal.norm())) return false;
    const WalkPlane plane{from.point, upright.normalized(), zero_is_left};
    const PlacedChain& goal = chains_[static_cast<std::size_t>(to.chain)];
    int exit = set_out(plane, from, walk);
    for (int seams = 0; exit >= 0; ++seams) {
        const int edge = walk.on->boundary_edge(exit);
        if (walk.on == &surface(to.tile)) {
            const int count = goal.boundary_edges, steps = (edge - to.edge + count) % count;
            const bool on_chain = (edge - goal.first_edge + count) % count < goal.curve.edge_count();
            if (std::min(steps, count - steps) <= 1 || (on_chain && (walk.at - to.point).norm() <= reach)) return true;
        }
        if (seams == most_seams) return false;
        exit = cross_seam(plane, edge, reach, walk);
    }
    return false;
}

bool ClothAcross::joins(const Touch& touch) const {
    const WalkEnd a = place_on(touch.a, touch.at_a), b = place_on(touch.b, touch.at_b);
    if (!((a.point - b.point).norm() > 0)) return false;
    for (const WalkEnd* place : {&a, &b})
        if (surface(place->tile).tile.mesh.triangle_count() == 0) return false;
    return walk_arrives(a, b, false) || walk_arrives(a, b, true) || walk_arrives(b, a, false) ||
           walk_arrives(b, a, true);
}

}  // namespace ripstop
