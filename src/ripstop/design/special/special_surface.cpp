#include "ripstop/design/special/special_surface.h"

#include <algorithm>

#include "ripstop/mesh/adjacency.h"

namespace ripstop {

WorkSurface::WorkSurface(const TriangleMesh& mesh) {
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    for (int v = 0; v < mesh.vertex_count(); ++v) position.emplace_back(mesh.positions.row(v));
    is_fixed.assign(position.size(), 0);
    leaving_.assign(position.size(), -1);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        corners_.push_back({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
        for (int k = 0; k < 3; ++k) {
            twins_.push_back(adjacency.twin(3 * t + k));
            leaving_[at(mesh.triangles(t, k))] = 3 * t + k;
        }
    }
    cell.resize(corners_.size());
    tile.assign(corners_.size(), -1);
    curves_.assign(twins_.size(), -1);
}

void WorkSurface::draw(int h, int curve) {
    curves_[at(h)] = curve;
    curves_[at(twin(h))] = curve;
}

void WorkSurface::leaving(int v, std::vector<int>& half_edges) const {
    half_edges.clear();
    const int first = leaving_[at(v)];
    int h = first;
    do {
        half_edges.push_back(h);
        h = twin(previous(h));
    } while (h != first);
}

bool WorkSurface::joined(int a, int b) const {
    const int first = leaving_[at(a)];
    int h = first;
    do {
        if (to(h) == b) return true;
        h = twin(previous(h));
    } while (h != first);
    return false;
}

int WorkSurface::add_triangle(int like, int a, int b, int c) {
    const int t = triangle_count();
    corners_.push_back({a, b, c});
    twins_.insert(twins_.end(), 3, -1);
    curves_.insert(curves_.end(), 3, -1);
    cell.push_back(cell[at(like)]);
    tile.push_back(tile[at(like)]);
    return t;
}

void WorkSurface::set(int t, int a, int b, int c) {
    corners_[at(t)] = {a, b, c};
    leaving_[at(a)] = 3 * t;
    leaving_[at(b)] = 3 * t + 1;
    leaving_[at(c)] = 3 * t + 2;
}

void WorkSurface::pair(int h, int g, int curve) {
    twins_[at(h)] = g;
    twins_[at(g)] = h;
    curves_[at(h)] = curve;
    curves_[at(g)] = curve;
}

WorkSurface::Diamond WorkSurface::around(int h) const {
    const int g = twin(h);
    Diamond d{h / 3, g / 3, from(h), to(h), opposite(h), opposite(g), {}, {}};
    d.outer = {twin(next(h)), twin(previous(h)), twin(next(g)), twin(previous(g))};
    for (std::size_t k = 0; k < 4; ++k) d.on[k] = curve(d.outer[k]);
    return d;
}

int WorkSurface::split(int h, const Vec3& place) {
    const auto [t, u, a, b, c, d, outer, on] = around(h);
    const int on_edge = curve(h);
    const int m = vertex_count();
    position.push_back(place);
    is_fixed.push_back(0);
    leaving_.push_back(-1);
    const int v = add_triangle(t, m, b, c);
    const int w = add_triangle(u, m, a, d);
    set(t, a, m, c);
    set(u, b, m, d);
    set(v, m, b, c);
    set(w, m, a, d);
    pair(3 * t, 3 * w, on_edge);
    pair(3 * u, 3 * v, on_edge);
    pair(3 * t + 1, 3 * v + 2, -1);
    pair(3 * u + 1, 3 * w + 2, -1);
    pair(3 * v + 1, outer[bc], on[bc]);
    pair(3 * t + 2, outer[ca], on[ca]);
    pair(3 * w + 1, outer[ad], on[ad]);
    pair(3 * u + 2, outer[db], on[db]);
    return m;
}

void WorkSurface::flip(int h) {
    const auto [t, u, a, b, c, d, outer, on] = around(h);
    set(t, c, d, b);
    set(u, d, c, a);
    pair(3 * t, 3 * u, -1);
    pair(3 * t + 1, outer[db], on[db]);
    pair(3 * t + 2, outer[bc], on[bc]);
    pair(3 * u + 1, outer[ca], on[ca]);
    pair(3 * u + 2, outer[ad], on[ad]);
}

bool WorkSurface::can_collapse(int h) const {
    const int a = from(h);
    const int b = to(h);
    if (is_fixed[at(a)]) return false;
    const int c = opposite(h);
    const int d = opposite(twin(h));
    if (c == d) return false;
    std::vector<int> near;
    leaving(a, near);
    int shared = 0;
    for (const int e : near) shared += to(e) != b && joined(to(e), b);
    if (shared != 2) return false;
    for (const int side : {h, twin(h)}) {
        leaving(opposite(side), near);
        if (near.size() < 4) return false;
        if (curve(next(side)) >= 0 && curve(previous(side)) >= 0) return false;
    }
    return true;
}

void WorkSurface::collapse(int h) {
    const int a = from(h);
    const int b = to(h);
    std::vector<int> around;
    leaving(a, around);
    for (const int side : {h, twin(h)}) {
        const int one = twin(next(side));
        const int other = twin(previous(side));
        const int on = std::max(curve(one), curve(other));
        const int c = opposite(side);
        pair(one, other, on);
        // One of `one` and `other` leaves c, the other one leaves the future b.
        leaving_[at(c)] = from(one) == c ? one : other;
        leaving_[at(b)] = from(one) == c ? other : one;
    }
    for (const int e : around) corners_[at(e / 3)][at(e % 3)] = b;
    for (const int t : {h / 3, twin(h) / 3}) corners_[at(t)] = {-1, -1, -1};
    leaving_[at(a)] = -1;
}

}  // namespace ripstop
