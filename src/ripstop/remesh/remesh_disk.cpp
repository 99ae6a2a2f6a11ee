// The only source that includes CGAL (GPL-3): docs/decisions/0003-cgal.md. It is slow to compile.
#include "ripstop/remesh/remesh_disk.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#ifdef RIPSTOP_CGAL

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include "ripstop/base/text/units.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

constexpr int first_rounds = 3;          // before boundary vertices are removed, so that no triangle there is flat
constexpr int rounds = 6;                // of split, collapse, flip and smooth; more have no effect
constexpr int collapse_rounds = 8;       // with a remeshing round between them
constexpr double longest = 4.0 / 3;      // in edge lengths: CGAL splits longer edges
constexpr double shortest_locked = 0.7;  // in edge lengths: a tip has no room for longer ones
constexpr double least_turned_angle = 15 * degree;
constexpr int inner = -1, unwanted = -2;  // special values of a vertex's boundary place

struct Projection {
    const Mesh* mesh;
    const Tree* tree;
    Point operator()(Vertex v) const { return tree->closest_point(mesh->point(v)); }
};

Vec3 vector_of(const Point& p) {
    return {p.x(), p.y(), p.z()};
}

Mesh surface_mesh(const TriangleMesh& mesh) {
    Mesh result;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        result.add_vertex({mesh.positions(v, 0), mesh.positions(v, 1), mesh.positions(v, 2)});
    const auto vertex = [](int v) { return Vertex(static_cast<Mesh::size_type>(v)); };
    for (int t = 0; t < mesh.triangle_count(); ++t)
        result.add_face(vertex(mesh.triangles(t, 0)), vertex(mesh.triangles(t, 1)), vertex(mesh.triangles(t, 2)));
    return result;
}

/// The mesh during remeshing: the vertices at the requested boundary places and the edges to keep.
class Remesher {
  public:
    Remesher(const TriangleMesh& mesh, double edge_length)
        : old_(surface_mesh(mesh)),
          tree_(faces(old_).first, faces(old_).second, old_),
          mesh_(old_),
          place_(mesh_.add_property_map<Vertex, int>("v:place", inner).first),
          kept_(mesh_.add_property_map<Edge, bool>("e:kept", false).first),
          length_(edge_length) {}

    void set_creases(const std::vector<std::array<int, 2>>& creases) {
        std::vector<Edge> edges;
        for (const auto& [a, b] : creases) {
            const Halfedge h =
                mesh_.halfedge(Vertex(static_cast<Mesh::size_type>(a)), Vertex(static_cast<Mesh::size_type>(b)));
            if (!mesh_.is_valid(h) || mesh_.is_border(mesh_.edge(h))) continue;
            edges.push_back(mesh_.edge(h));
            kept_[edges.back()] = true;
        }
        if (!edges.empty())
            pmp::split_long_edges(edges, longest * length_, mesh_, CGAL::parameters::edge_is_constrained_map(kept_));
    }

    void set_boundary(const std::vector<int>& boundary, const std::vector<BoundaryPlace>& places) {
        for (const int v : boundary) place_[Vertex(static_cast<Mesh::size_type>(v))] = unwanted;
        for (std::size_t j = 0; j < places.size();) {
            const std::size_t edge = static_cast<std::size_t>(places[j].edge);
            const Vertex a(static_cast<Mesh::size_type>(boundary[edge]));
            const Vertex b(static_cast<Mesh::size_type>(boundary[(edge + 1) % boundary.size()]));
            const Vec3 start = vector_of(mesh_.point(a)), end = vector_of(mesh_.point(b));
            Halfedge h = mesh_.halfedge(a, b);
            for (; j < places.size() && places[j].edge == static_cast<int>(edge); ++j) {
                if (places[j].share == 0) {
                    place_[a] = static_cast<int>(j);
                    continue;
                }
                const Vec3 at = start + places[j].share * (end - start);
                const Halfedge before = split(h);
                mesh_.point(mesh_.target(before)) = Point(at.x(), at.y(), at.z());
                place_[mesh_.target(before)] = static_cast<int>(j);
            }
        }
        keep_border();
    }

    /// Collapses unwanted boundary vertices where the adjacent triangles allow it, with rounds of remeshing in
    /// between.
    void thin_boundary() {
        if (count_unwanted() == 0) return;
        remesh(first_rounds);
        for (int round = 0; round < collapse_rounds; ++round) {
            while (collapse_unwanted()) {
            }
            keep_border();
            if (count_unwanted() == 0) return;
            remesh(1);
        }
        throw std::runtime_error("the boundary is too crumpled to be divided again");
    }

    void remesh(int count) {
        pmp::isotropic_remeshing(faces(mesh_), length_, mesh_,
                                 CGAL::parameters::number_of_iterations(static_cast<unsigned>(count))
                                     .edge_is_constrained_map(kept_)
                                     .protect_constraints(true)
                                     .projection_functor(Projection{&mesh_, &tree_}));
    }

    void unlock() {
        for (const Edge e : locked_edges()) {
            if (is_ear(e)) {
                flip_ear(e);
            } else if (edge_length(e) > shortest_locked * length_) {
                const Vec3 middle =
                    (vector_of(mesh_.point(mesh_.vertex(e, 0))) + vector_of(mesh_.point(mesh_.vertex(e, 1)))) / 2;
                const Vertex added = mesh_.target(split(mesh_.halfedge(e)));
                mesh_.point(added) = tree_.closest_point(Point(middle.x(), middle.y(), middle.z()));
            }
        }
        pmp::isotropic_remeshing(faces(mesh_), length_, mesh_,
                                 CGAL::parameters::number_of_iterations(2)
                                     .edge_is_constrained_map(kept_)
                                     .protect_constraints(true)
                                     .do_split(false)
                                     .do_collapse(false)
                                     .do_flip(false)
                                     .projection_functor(Projection{&mesh_, &tree_}));
    }

    DiskRemesh result(const TriangleMesh& old, std::size_t place_count) const {
        std::vector<Vertex> order(place_count, Mesh::null_vertex());
        std::vector<int> number(mesh_.num_vertices(), -1);
        for (const Vertex v : mesh_.vertices())
            if (place_[v] >= 0) order[static_cast<std::size_t>(place_[v])] = v;
        for (const Vertex v : mesh_.vertices())
            if (place_[v] < 0) order.push_back(v);
        DiskRemesh result;
        result.mesh.positions.resize(static_cast<Eigen::Index>(order.size()), 3);
        for (std::size_t i = 0; i < order.size(); ++i) {
            if (order[i] == Mesh::null_vertex()) throw std::runtime_error("a vertex of the boundary was lost");
            number[order[i]] = static_cast<int>(i);
            const Vec3 at = vector_of(mesh_.point(order[i]));
            result.mesh.positions.row(static_cast<Eigen::Index>(i)) = at;
            result.places.push_back(place_of(old, at));
        }
        result.mesh.triangles.resize(static_cast<Eigen::Index>(mesh_.number_of_faces()), 3);
        int t = 0;
        for (const Face f : mesh_.faces()) {
            int k = 0;
            for (const Vertex v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_))
                result.mesh.triangles(t, k++) = number[v];
            const Vec3 middle = (result.mesh.corner(t, 0) + result.mesh.corner(t, 1) + result.mesh.corner(t, 2)) / 3;
            result.origin.push_back(place_of(old, middle).triangle);
            ++t;
        }
        return result;
    }

  private:
    /// Splits an edge and connects the new vertex to the opposite corners. Returns the halfedge that ends there; `h`
    /// starts there.
    Halfedge split(Halfedge h) {
        const Halfedge before = CGAL::Euler::split_edge(h, mesh_);
        if (!mesh_.is_border(before)) CGAL::Euler::split_face(before, mesh_.next(h), mesh_);
        const Halfedge other = mesh_.opposite(h);
        if (!mesh_.is_border(other)) CGAL::Euler::split_face(other, mesh_.next(mesh_.opposite(before)), mesh_);
        return before;
    }

    void keep_border() {
        for (const Edge e : mesh_.edges())
            if (mesh_.is_border(e)) kept_[e] = true;
    }

    int count_unwanted() const {
        int count = 0;
        for (const Vertex v : mesh_.vertices()) count += place_[v] == unwanted ? 1 : 0;
        return count;
    }

    /// One pass that collapses each unwanted vertex onto the nearer of its boundary neighbours. Returns true if any
    /// collapsed.
    bool collapse_unwanted() {
        std::vector<Vertex> waiting;
        for (const Vertex v : mesh_.vertices())
            if (place_[v] == unwanted) waiting.push_back(v);
        bool changed = false;
        for (const Vertex v : waiting) {
            if (mesh_.is_removed(v) || place_[v] != unwanted) continue;
            Halfedge into = mesh_.halfedge(v);  // for a boundary vertex, the halfedge without a triangle
            for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_))
                if (mesh_.is_border(h)) into = h;
            const Halfedge out = mesh_.next(into);
            const bool back_is_nearer = edge_length(mesh_.edge(into)) < edge_length(mesh_.edge(out));
            const Edge first = mesh_.edge(back_is_nearer ? into : out);
            const Edge second = mesh_.edge(back_is_nearer ? out : into);
            changed = collapse_onto_other_end(first, v) || collapse_onto_other_end(second, v) || changed;
        }
        return changed;
    }

    bool collapse_onto_other_end(Edge e, Vertex v) {
        if (!mesh_.is_valid(e) || mesh_.is_removed(e)) return false;
        const Vertex w = mesh_.vertex(e, 0) == v ? mesh_.vertex(e, 1) : mesh_.vertex(e, 0);
        if (mesh_.is_removed(v) || !keeps_upright(v, w) || !CGAL::Euler::does_satisfy_link_condition(e, mesh_))
            return false;
        const Point at = mesh_.point(w);
        const int place = place_[w];
        const Vertex left = CGAL::Euler::collapse_edge(e, mesh_, kept_);
        mesh_.point(left) = at;
        place_[left] = place;
        return true;
    }

    /// Whether no triangle at v flips or degenerates when v moves onto w.
    bool keeps_upright(Vertex v, Vertex w) const {
        const Vec3 to = vector_of(mesh_.point(w));
        for (const Halfedge h : CGAL::halfedges_around_target(v, mesh_)) {
            if (mesh_.is_border(h)) continue;
            const Vertex a = mesh_.target(mesh_.next(h)), b = mesh_.source(h);
            if (a == w || b == w) continue;
            const Vec3 p = vector_of(mesh_.point(a)), q = vector_of(mesh_.point(b));
            const Vec3 from = vector_of(mesh_.point(v));
            const Vec3 before = (p - from).cross(q - from), after = (p - to).cross(q - to);
            if (!(before.dot(after) > 0.5 * before.norm() * after.norm()) ||
                !(after.norm() > 1e-3 * (p - q).squaredNorm()))
                return false;
        }
        return true;
    }

    double edge_length(Edge e) const {
        return (vector_of(mesh_.point(mesh_.vertex(e, 0))) - vector_of(mesh_.point(mesh_.vertex(e, 1)))).norm();
    }

    std::vector<Edge> locked_edges() const {
        std::vector<Edge> edges;
        for (const Edge e : mesh_.edges())
            if (!mesh_.is_border(e) && !kept_[e] && place_[mesh_.vertex(e, 0)] >= 0 && place_[mesh_.vertex(e, 1)] >= 0)
                edges.push_back(e);
        return edges;
    }

    bool is_ear(Edge e) const {
        for (const Halfedge h : {mesh_.halfedge(e), mesh_.opposite(mesh_.halfedge(e))})
            if (mesh_.is_border(mesh_.edge(mesh_.next(h))) && mesh_.is_border(mesh_.edge(mesh_.prev(h)))) return true;
        return false;
    }

    void flip_ear(Edge e) {
        const Halfedge h = mesh_.halfedge(e), o = mesh_.opposite(h);
        const Vertex p = mesh_.source(h), q = mesh_.target(h);
        const Vertex r = mesh_.target(mesh_.next(h)), s = mesh_.target(mesh_.next(o));
        if (place_[r] >= 0 && place_[s] >= 0) return;
        if (mesh_.is_valid(mesh_.halfedge(r, s))) return;
        const Vec3 a = vector_of(mesh_.point(p)), b = vector_of(mesh_.point(q));
        const Vec3 c = vector_of(mesh_.point(r)), d = vector_of(mesh_.point(s));
        // area vectors of (p, r, s) and (q, s, r), from s
        const Vec3 one = (a - d).cross(c - d), other = (c - d).cross(b - d);
        if (!(one.dot(other) > 0.5 * one.norm() * other.norm())) return;
        const auto least = [](const Vec3& x, const Vec3& y, const Vec3& z) {
            return std::min({angle_at(x, y, z), angle_at(y, z, x), angle_at(z, x, y)});
        };
        const double flat = std::min(least(a, b, c), least(a, b, d)), turned = std::min(least(a, c, d), least(b, c, d));
        if (turned < least_turned_angle && turned < flat) return;
        CGAL::Euler::flip_edge(h, mesh_);
    }

    MeshPlace place_of(const TriangleMesh& old, const Vec3& at) const {
        const auto [point, face] = tree_.closest_point_and_primitive(Point(at.x(), at.y(), at.z()));
        const int t = static_cast<int>(face);
        const Vec3 a = old.corner(t, 0), u = old.corner(t, 1) - a, v = old.corner(t, 2) - a, p = vector_of(point) - a;
        const Vec3 normal = u.cross(v);
        Vec3 weights(0, p.cross(v).dot(normal), u.cross(p).dot(normal));
        weights /= normal.squaredNorm();
        weights[0] = 1 - weights[1] - weights[2];
        weights = weights.cwiseMax(0);
        return {t, weights / weights.sum()};
    }

    Mesh old_;
    Tree tree_;
    Mesh mesh_;
    Mesh::Property_map<Vertex, int> place_;
    Mesh::Property_map<Edge, bool> kept_;
    double length_;
};

}  // namespace

DiskRemesh remesh_disk(const TriangleMesh& mesh, const std::vector<int>& boundary,
                       const std::vector<BoundaryPlace>& places, const std::vector<std::array<int, 2>>& creases,
                       double edge_length) {
    Remesher remesher(mesh, edge_length);
    remesher.set_creases(creases);
    remesher.set_boundary(boundary, places);
    remesher.thin_boundary();
    remesher.remesh(rounds);
    remesher.unlock();
    return remesher.result(mesh, places.size());
}

bool can_remesh() {
    return true;
}

}  // namespace ripstop

#else

namespace ripstop {

DiskRemesh remesh_disk(const TriangleMesh&, const std::vector<int>&, const std::vector<BoundaryPlace>&,
                       const std::vector<std::array<int, 2>>&, double) {
    throw std::runtime_error("this program was built without CGAL");
}

bool can_remesh() {
    return false;
}

}  // namespace ripstop

#endif
