#include "ripstop/design/special/special_cut.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ripstop/base/index.h"
#include "ripstop/design/special/special_settle.h"

namespace ripstop {
namespace {

/// Splits edges where a function of the vertices changes sign, on a given set of triangles.
class Cut {
  public:
    Cut(WorkSurface& surface, const SpecialBody& body, const std::function<double(const Vec3&)>& side,
        std::function<bool(int)> is_meant)
        : surface_(surface), body_(body), is_meant_(std::move(is_meant)) {
        constexpr double on_it = 1e-9;  // [m]
        for (const Vec3& place : surface.position) {
            const double value = side(place);
            sides_.push_back(std::abs(value) < on_it ? 0 : value);
        }
    }

    /// `ties` returns what the new vertex must lie on, in addition to what the edge lies on. An edge for which it
    /// returns nothing is not split.
    void run(const std::function<Ties(const Vec3&)>& ties) {
        // A split moves edges that were not visited yet to triangles at the end.
        for (int h = 0; h < surface_.half_edge_count(); ++h) {
            if (!surface_.is_edge(h)) continue;
            const double a = sides_[at(surface_.from(h))];
            const double b = sides_[at(surface_.to(h))];
            if (!(a * b < 0) || !(is_meant_(h / 3) || is_meant_(surface_.twin(h) / 3))) continue;
            const double share = a / (a - b);
            Vec3 place =
                (1 - share) * surface_.position[at(surface_.from(h))] + share * surface_.position[at(surface_.to(h))];
            Ties tied = ties(place);
            if (tied.curves.empty() && tied.faces.empty()) continue;
            Ties edge_ties;
            add_edge_ties(h, place, edge_ties);
            for (const int face : edge_ties.faces) tied.add(face);
            for (const BodyCurve& curve : edge_ties.curves) tied.add(curve);
            // If the cut runs along an existing curve, the two may have no common point: then the existing curve has
            // priority.
            if (!settle(body_, tied, surface_.length(h), place)) settle(body_, edge_ties, surface_.length(h), place);
            surface_.split(h, place);
            sides_.push_back(0);
        }
    }

    /// The corner value of a triangle with the largest magnitude.
    double side_of(int t) const {
        double furthest = 0;
        for (int k = 0; k < 3; ++k)
            if (const double value = sides_[at(surface_.corner(t, k))]; std::abs(value) > std::abs(furthest))
                furthest = value;
        return furthest;
    }

  private:
    void add_edge_ties(int h, const Vec3& place, Ties& tied) const {
        const BodyCell& one = surface_.cell[at(h / 3)];
        const BodyCell& other = surface_.cell[at(surface_.twin(h) / 3)];
        tied.add(one.face);
        tied.add(other.face);
        if (one.face >= 0 && other.face >= 0 && !(one == other)) tied.add(body_.curve_between(one, other, place));
    }

    WorkSurface& surface_;
    const SpecialBody& body_;
    std::function<bool(int)> is_meant_;
    std::vector<double> sides_;
};

Vec3 middle(const WorkSurface& surface, int t) {
    return (surface.place(t, 0) + surface.place(t, 1) + surface.place(t, 2)) / 3;
}

/// Candidates for a piece of the surface: it belongs to the one with the lowest score.
struct Contenders {
    int count;
    std::function<double(int, const Vec3&)> score;
    std::function<int(int, const Vec3&)> face;  ///< the face of a candidate at a point
    std::function<bool(int)> is_open;           ///< whether a triangle is not assigned yet
    std::function<void(int, int)> give;         ///< assigns a triangle to a candidate

    int best_from(int first, const Vec3& x) const {
        int best = first;
        for (int c = first + 1; c < count; ++c)
            if (score(c, x) < score(best, x)) best = c;
        return best;
    }
};

/// Cuts the surface between the candidates, separating one after the other from the rest.
void divide(WorkSurface& surface, const SpecialBody& body, const Contenders& all) {
    for (int c = 0; c + 1 < all.count; ++c) {
        Cut cut(
            surface, body, [&](const Vec3& x) { return all.score(c, x) - all.score(all.best_from(c + 1, x), x); },
            all.is_open);
        cut.run([&](const Vec3& x) {
            const int mine = all.face(c, x);
            const int theirs = all.face(all.best_from(c + 1, x), x);
            Ties ties{{mine, theirs}, {}};
            ties.add(BodyCurve{BodyCurve::crease, std::min(mine, theirs), std::max(mine, theirs)});
            return ties;
        });
        for (int t = 0; t < surface.triangle_count(); ++t)
            if (surface.is_triangle(t) && all.is_open(t) && cut.side_of(t) < 0) all.give(t, c);
    }
    for (int t = 0; t < surface.triangle_count(); ++t)
        if (surface.is_triangle(t) && all.is_open(t)) all.give(t, all.count - 1);
}

void cut_along(WorkSurface& surface, const SpecialBody& body, const BodyCurve& curve,
               const std::function<bool(int)>& is_meant) {
    Cut(
        surface, body, [&](const Vec3& x) { return body.curve_level(curve, x).value; }, is_meant)
        .run([&](const Vec3& x) {
            return body.reaches(curve, x) ? Ties{{}, {curve}} : Ties{};
        });
}

/// Moves the primitive's own pole along the axis onto the surface of the body. Returns false if another primitive
/// covers it.
bool find_pole(const SpecialBody& body, int primitive, Vec3& pole) {
    const Vec3 axis = body.shape().primitives[at(primitive)].axis.stableNormalized();
    const double reach = body.shape().joint_radius + body.shape().edge_length;
    const Vec3 start = pole;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const int owner = body.owner(pole);
        if (body.primitive_number(owner) != primitive) return false;
        const Level level = body.surface_level(owner, pole);
        if (std::abs(level.value) < 1e-12) return true;
        const double rise = level.gradient.dot(axis);
        if (std::abs(rise) < 1e-3 || !((pole - start).norm() < reach)) return false;
        pole -= level.value / rise * axis;
    }
    return false;
}

}  // namespace

void set_poles(WorkSurface& surface, const SpecialBody& body) {
    for (int p = 0; p < static_cast<int>(body.shape().primitives.size()); ++p)
        for (Vec3 pole : body.poles(p)) {
            if (!find_pole(body, p, pole)) continue;
            int nearest = -1;
            double least = 1e300;
            for (int v = 0; v < surface.vertex_count(); ++v)
                if (const double distance = (surface.position[at(v)] - pole).squaredNorm();
                    surface.is_vertex(v) && !surface.is_fixed[at(v)] && distance < least) {
                    nearest = v;
                    least = distance;
                }
            if (nearest < 0) continue;
            surface.position[at(nearest)] = pole;
            surface.is_fixed[at(nearest)] = 1;
        }
}

void cut_creases(WorkSurface& surface, const SpecialBody& body) {
    const auto primitives = static_cast<int>(body.shape().primitives.size());
    divide(surface, body,
           {primitives, [&](int p, const Vec3& x) { return body.solid_level(p, x).value; },
            [&](int p, const Vec3& x) { return body.face_shown(p, x); },
            [&](int t) { return surface.cell[at(t)].face < 0; },
            [&](int t, int p) { surface.cell[at(t)].face = body.face_shown(p, middle(surface, t)); }});
    for (int p = 0; p < primitives; ++p) {
        const std::vector<int>& faces = body.faces_of(p);
        if (faces.size() == 1) continue;
        const auto face = [&](int c) { return faces[at(c)]; };
        divide(
            surface, body,
            {static_cast<int>(faces.size()), [&](int c, const Vec3& x) { return -body.face_level(face(c), x).value; },
             [&](int c, const Vec3&) { return face(c); },
             [&](int t) { return surface.tile[at(t)] < 0 && body.primitive_number(surface.cell[at(t)].face) == p; },
             [&](int t, int c) { surface.tile[at(t)] = surface.cell[at(t)].face = face(c); }});
    }
    std::fill(surface.tile.begin(), surface.tile.end(), -1);
}

void cut_seams(WorkSurface& surface, const SpecialBody& body) {
    const auto primitives = static_cast<int>(body.shape().primitives.size());
    const auto face_of = [&](int t) { return surface.cell[at(t)].face; };
    const auto corners = [&](int t, auto&& number) {
        const Vec3 places[3] = {surface.place(t, 0), surface.place(t, 1), surface.place(t, 2)};
        return number(body.primitive_number(face_of(t)), places);
    };
    for (int p = 0; p < primitives; ++p)
        for (const BodyCurve& curve : body.sector_curves(p))
            cut_along(surface, body, curve, [&](int t) { return body.primitive_number(face_of(t)) == p; });
    for (int t = 0; t < surface.triangle_count(); ++t)
        if (surface.is_triangle(t))
            surface.cell[at(t)].sector = corners(t, [&](int p, const auto& x) { return body.sector_of(p, x); });
    for (int p = 0; p < primitives; ++p)
        for (const BodyCurve& curve : body.ring_curves(p))
            cut_along(surface, body, curve, [&](int t) { return face_of(t) == body.faces_of(p)[0]; });
    for (int t = 0; t < surface.triangle_count(); ++t)
        if (surface.is_triangle(t) && body.faces()[at(face_of(t))].part == 0)
            surface.cell[at(t)].ring = corners(t, [&](int p, const auto& x) { return body.ring_of(p, x); });
    if (!body.shape().mouth) return;
    cut_along(surface, body, {BodyCurve::mouth, 0, 0}, [](int) { return true; });
    for (int t = 0; t < surface.triangle_count(); ++t)
        surface.cell[at(t)].below = surface.is_triangle(t) && middle(surface, t).z() < *body.shape().mouth;
}

}  // namespace ripstop
