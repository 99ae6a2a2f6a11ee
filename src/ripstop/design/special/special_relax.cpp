#include "ripstop/design/special/special_relax.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "ripstop/base/index.h"
#include "ripstop/base/text/units.h"
#include "ripstop/design/special/special_settle.h"
#include "ripstop/geometry/triangle.h"

namespace ripstop {
namespace {

class Relaxation {
  public:
    Relaxation(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge)
        : surface_(surface), body_(body), curves_(curves), edge_(edge) {}

    void split_long() {
        const int edges = surface_.half_edge_count();  // new ones wait for the next round
        for (int h = 0; h < edges; ++h)
            if (surface_.is_edge(h) && surface_.length(h) > 4.0 / 3 * edge_) split_in_half(h);
    }

    void split_in_half(int h) {
        Vec3 place = (surface_.position[at(surface_.from(h))] + surface_.position[at(surface_.to(h))]) / 2;
        Ties ties;
        ties.add(surface_.cell[at(h / 3)].face);
        ties.add(surface_.cell[at(surface_.twin(h) / 3)].face);
        if (surface_.curve(h) >= 0) ties.add(curves_[at(surface_.curve(h))]);
        const Vec3 middle = place;
        // Where the body turns sharply, the nearest point may be far away; a later round moves the vertex onto the
        // body.
        if (!settle(body_, ties, surface_.length(h), place) || (place - middle).norm() > 0.4 * surface_.length(h))
            place = middle;
        surface_.split(h, place);
    }

    void collapse_short() {
        for (int h = 0; h < surface_.half_edge_count(); ++h)
            if (surface_.is_edge(h) && surface_.length(h) < 0.75 * edge_ && !collapse(h)) collapse(surface_.twin(h));
    }

    /// Merges corners that almost coincide, such as where two seams meet a third from both sides.
    void join_corners() {
        for (int h = 0; h < surface_.half_edge_count(); ++h)
            if (surface_.is_edge(h) && surface_.curve(h) >= 0 && surface_.length(h) < 0.25 * edge_ &&
                !collapse_corner(h))
                collapse_corner(surface_.twin(h));
    }

    void flip_all() {
        for (int h = 0; h < surface_.half_edge_count(); ++h)
            if (surface_.is_edge(h) && surface_.curve(h) < 0) flip_if_better(h);
    }

    /// Moves all vertices onto the body, whatever happens to the triangles.
    void settle_all() {
        for (int v = 0; v < surface_.vertex_count(); ++v) {
            if (!surface_.is_vertex(v) || surface_.is_fixed[at(v)]) continue;
            surface_.leaving(v, around_);
            settle(body_, ties_of(around_), edge_, surface_.position[at(v)]);
        }
    }

    void move_all() {
        for (int v = 0; v < surface_.vertex_count(); ++v)
            if (surface_.is_vertex(v) && !surface_.is_fixed[at(v)]) move(v);
    }

    /// Whether an edge inside a tile joins two vertices of its seams, and the angles that a split divides are wide.
    bool bridges(int h) {
        if (surface_.curve(h) >= 0) return false;
        constexpr double wide = 35 * degree;
        for (const int side : {h, surface_.twin(h)})
            if (angle_at(surface_.position[at(surface_.opposite(side))], surface_.position[at(surface_.from(side))],
                         surface_.position[at(surface_.to(side))]) < wide)
                return false;
        for (const int v : {surface_.from(h), surface_.to(h)}) {
            surface_.leaving(v, near_);
            if (drawn_at(near_) == 0) return false;
        }
        return true;
    }

  private:
    int drawn_at(const std::vector<int>& leaving) const {
        return static_cast<int>(
            std::count_if(leaving.begin(), leaving.end(), [&](int e) { return surface_.curve(e) >= 0; }));
    }

    /// 0: moves freely, 1: moves along its curve, 2: fixed.
    int bonds(int v) {
        surface_.leaving(v, near_);
        const int drawn = drawn_at(near_);
        if (surface_.is_fixed[at(v)]) return 2;
        if (drawn == 0) return 0;
        int curve = -1;
        for (const int e : near_)
            if (surface_.curve(e) >= 0) {
                if (curve >= 0 && surface_.curve(e) != curve) return 2;
                curve = surface_.curve(e);
            }
        return drawn == 2 ? 1 : 2;
    }

    Ties ties_of(const std::vector<int>& leaving) const {
        Ties ties;
        for (const int e : leaving) {
            ties.add(surface_.cell[at(e / 3)].face);
            if (surface_.curve(e) >= 0) ties.add(curves_[at(surface_.curve(e))]);
        }
        return ties;
    }

    double quality(int t) const {
        return shape_quality(body_, surface_.cell[at(t)].face, surface_.place(t, 0), surface_.place(t, 1),
                             surface_.place(t, 2));
    }
    double quality_with(int t, int v, const Vec3& place) const {
        Vec3 corners[3];
        for (int k = 0; k < 3; ++k) corners[k] = surface_.corner(t, k) == v ? place : surface_.place(t, k);
        return shape_quality(body_, surface_.cell[at(t)].face, corners[0], corners[1], corners[2]);
    }

    /// Collapses the edge into its second vertex, or into its midpoint if both vertices are equally free.
    bool collapse(int h) {
        const int a = surface_.from(h);
        const int b = surface_.to(h);
        const int bonds_b = bonds(b);
        const int bonds_a = bonds(a);
        if (bonds_a == 2 || bonds_b < bonds_a || (bonds_a == 1 && surface_.curve(h) < 0)) return false;
        if (!surface_.can_collapse(h)) return false;
        surface_.leaving(a, around_);
        Ties ties = ties_of(around_);
        Vec3 place = surface_.position[at(b)];
        const bool moves_both = bonds_a == bonds_b;
        surface_.leaving(b, beyond_);
        if (moves_both) {
            if (bonds_a == 0) ties.faces.resize(std::min<std::size_t>(ties.faces.size(), 1));
            place = (surface_.position[at(a)] + place) / 2;
            if (!settle(body_, ties, edge_, place)) return false;
        }
        double before = 1;
        double after = 1;
        double longest = 0;
        const auto weigh = [&](const std::vector<int>& leaving, int v) {
            for (const int e : leaving) {
                const int t = e / 3;
                before = std::min(before, quality(t));
                longest = std::max(longest, (surface_.position[at(surface_.to(e))] - place).norm());
                if (t != h / 3 && t != surface_.twin(h) / 3) after = std::min(after, quality_with(t, v, place));
            }
        };
        weigh(around_, a);
        if (moves_both) weigh(beyond_, b);
        if (after < 0.3 && after <= before) return false;
        if (longest > 1.4 * edge_ && before > 0.3) return false;
        surface_.collapse(h);
        surface_.position[at(b)] = place;
        return true;
    }

    bool collapse_corner(int h) {
        const int a = surface_.from(h);
        const int b = surface_.to(h);
        if (bonds(a) != 2 || bonds(b) != 2 || !surface_.can_collapse(h)) return false;
        surface_.leaving(a, around_);
        surface_.leaving(b, beyond_);
        const Ties own = ties_of(around_);
        const Ties others = ties_of(beyond_);
        for (const int face : own.faces)
            if (std::find(others.faces.begin(), others.faces.end(), face) == others.faces.end()) return false;
        double before = 1;
        double after = 1;
        for (const int e : around_) {
            before = std::min(before, quality(e / 3));
            if (e / 3 != h / 3 && e / 3 != surface_.twin(h) / 3)
                after = std::min(after, quality_with(e / 3, a, surface_.position[at(b)]));
        }
        if (after < 0.2 && after <= before) return false;
        surface_.collapse(h);
        return true;
    }

    void flip_if_better(int h) {
        const int g = surface_.twin(h);
        const int c = surface_.opposite(h);
        const int d = surface_.opposite(g);
        if (c == d || surface_.joined(c, d)) return;
        for (const int v : {surface_.from(h), surface_.to(h)}) {
            surface_.leaving(v, near_);
            if (near_.size() < 4) return;
        }
        const Vec3& a = surface_.position[at(surface_.from(h))];
        const Vec3& b = surface_.position[at(surface_.to(h))];
        const Vec3& p = surface_.position[at(c)];
        const Vec3& q = surface_.position[at(d)];
        const int face = surface_.cell[at(h / 3)].face;
        const double before = std::min(quality(h / 3), quality(g / 3));
        const double after = std::min(shape_quality(body_, face, p, q, b), shape_quality(body_, face, q, p, a));
        if (after > before + 1e-6) surface_.flip(h);
    }

    Vec3 goal(int v, int bound) const {
        if (bound == 1) {
            Vec3 sum = Vec3::Zero();
            for (const int e : around_)
                if (surface_.curve(e) >= 0) sum += surface_.position[at(surface_.to(e))] / 2;
            return sum;
        }
        Vec3 sum = Vec3::Zero();
        double weight = 0;
        for (const int e : around_) {
            const Vec3 a = surface_.position[at(surface_.to(e))];
            const Vec3 b = surface_.position[at(surface_.opposite(e))];
            const double area = (a - surface_.position[at(v)]).cross(b - surface_.position[at(v)]).norm();
            sum += area * (a + b + surface_.position[at(v)]) / 3;
            weight += area;
        }
        return weight > 0 ? Vec3(sum / weight) : surface_.position[at(v)];
    }

    void move(int v) {
        const int bound = bonds(v);
        if (bound == 2) return;
        surface_.leaving(v, around_);
        Ties ties = ties_of(around_);
        double before = 1;
        for (const int e : around_) before = std::min(before, quality(e / 3));
        const Vec3 wanted = goal(v, bound);
        for (const double share : {1.0, 0.5, 0.2}) {
            Vec3 place = (1 - share) * surface_.position[at(v)] + share * wanted;
            if (!settle(body_, ties, edge_, place)) continue;
            double after = 1;
            for (const int e : around_) after = std::min(after, quality_with(e / 3, v, place));
            if (after < 0.5 && after <= before) continue;
            surface_.position[at(v)] = place;
            return;
        }
    }

    WorkSurface& surface_;
    const SpecialBody& body_;
    const std::vector<BodyCurve>& curves_;
    double edge_;
    std::vector<int> near_, around_, beyond_;
};

}  // namespace

double shape_quality(const SpecialBody& body, int face, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    if (!(squares > 0)) return 0;
    const Vec3 middle = (a + b + c) / 3;
    const Vec3 normal = body.surface_level(face >= 0 ? face : body.owner(middle), middle).gradient.normalized();
    return 2 * std::sqrt(3.0) * (b - a).cross(c - a).dot(normal) / squares;
}

void relax(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge,
           int rounds) {
    Relaxation relaxation(surface, body, curves, edge);
    relaxation.settle_all();
    for (int round = 0; round < rounds; ++round) {
        relaxation.split_long();
        relaxation.collapse_short();
        relaxation.join_corners();
        relaxation.flip_all();
        relaxation.move_all();
    }
    for (int round = 0; round < 3; ++round) {
        relaxation.flip_all();
        relaxation.move_all();
    }
}

void straighten_creases(WorkSurface& surface, const SpecialBody& body) {
    const auto face = [&](int t) { return surface.cell[at(t)].face; };
    for (int pass = 0; pass < 4; ++pass)
        for (int t = 0; t < surface.triangle_count(); ++t) {
            if (!surface.is_triangle(t)) continue;
            int across[3];
            for (int k = 0; k < 3; ++k) across[k] = face(surface.twin(3 * t + k) / 3);
            for (int k = 0; k < 3; ++k)
                if (const int other = across[k];
                    other != face(t) && other == across[(k + 1) % 3] &&
                    shape_quality(body, face(t), surface.place(t, 0), surface.place(t, 1), surface.place(t, 2)) < 0.2)
                    surface.cell[at(t)].face = other;
        }
}

void relax_corners(WorkSurface& surface, const SpecialBody& body, const std::vector<BodyCurve>& curves, double edge) {
    Relaxation relaxation(surface, body, curves, edge);
    for (int h = 0; h < surface.half_edge_count(); ++h)
        if (surface.is_edge(h) && relaxation.bridges(h)) relaxation.split_in_half(h);
    for (int round = 0; round < 3; ++round) relaxation.move_all();
}

}  // namespace ripstop
