#include "uv_mesh.h"

#include <algorithm>

#include "ripstop/geometry/predicates.h"

namespace ripstop::cad {
namespace {

constexpr int next(int k) {
    return (k + 1) % 3;
}
constexpr int before(int k) {
    return (k + 2) % 3;
}

}  // namespace

UvMesh::UvMesh(const Vec2& middle, double reach) {
    const double far = 8 * reach;
    add(middle + Vec2(-far, -far));
    add(middle + Vec2(far, -far));
    add(middle + Vec2(0, far));
    place({0, 1, 2}, -1);
}

int UvMesh::add(const Vec2& where) {
    at.push_back(where);
    some_.push_back(-1);
    return static_cast<int>(at.size()) - 1;
}

void UvMesh::drop_last() {
    at.pop_back();
    some_.pop_back();
}

/// Makes a triangle with these corners, a new one or in place of `triangle`. The caller must join its neighbours.
int UvMesh::place(const std::array<int, 3>& corners, int triangle) {
    if (triangle < 0) {
        triangle = triangle_count();
        corners_.emplace_back();
        beside_.emplace_back();
        fixed_.emplace_back();
    }
    corners_[index(triangle)] = corners;
    fixed_[index(triangle)] = {false, false, false};
    for (const int node : corners) some_[index(node)] = triangle;
    changed_.push_back(triangle);
    return triangle;
}

void UvMesh::join(const Side& a, const Side& b) {
    beside_[index(a.triangle)][index(a.corner)] = b;
    if (b.triangle >= 0) beside_[index(b.triangle)][index(b.corner)] = a;
}

UvMesh::Side UvMesh::across(const Side& side) const {
    return beside_[index(side.triangle)][index(side.corner)];
}

std::array<int, 2> UvMesh::ends(const Side& side) const {
    const auto& corners = corners_[index(side.triangle)];
    return {corners[index(next(side.corner))], corners[index(before(side.corner))]};
}

bool UvMesh::turns_left(int triangle) const {
    const auto& [a, b, c] = corners_[index(triangle)];
    return orient2d(at[index(a)], at[index(b)], at[index(c)]) > 0;
}

UvMesh::Side UvMesh::left_at(int triangle, const Vec2& p) const {
    // Visibility walk. The triangulation need not be Delaunay, so the walk begins at a different side in each
    // step.
    int turn = 0;
    for (std::size_t steps = 0; steps < 4 * corners_.size() + 64; ++steps) {
        bool stays = true;
        for (int i = 0; i < 3 && stays; ++i) {
            const int k = (i + turn) % 3;
            const auto [a, b] = ends({triangle, k});
            if (orient2d(at[index(a)], at[index(b)], p) >= 0) continue;
            const Side there = across({triangle, k});
            if (there.triangle < 0) return {-1, 0};
            triangle = there.triangle;
            stays = false;
        }
        if (stays) return {triangle, 0};
        turn = (turn + 1) % 3;
    }
    return {-1, 0};
}

void UvMesh::split_triangle(int triangle, int node) {
    const auto [a, b, c] = corners_[index(triangle)];
    const auto outer = beside_[index(triangle)];
    const auto fixed = fixed_[index(triangle)];
    const std::array<int, 3> made{place({node, b, c}, triangle), place({node, c, a}, -1), place({node, a, b}, -1)};
    for (std::size_t k = 0; k < 3; ++k) {
        join({made[k], 0}, outer[k]);
        fixed_[index(made[k])][0] = fixed[k];
        join({made[k], 1}, {made[(k + 1) % 3], 2});
    }
}

bool UvMesh::split(const Side& side, int node) {
    const Side other = across(side);
    const auto [a, b] = ends(side);
    const int c = corners_[index(side.triangle)][index(side.corner)];
    const Vec2& p = at[index(node)];
    const auto is_left = [&](int i, int j) { return orient2d(at[index(i)], at[index(j)], p) > 0; };
    if (!is_left(b, c) || !is_left(c, a)) return false;
    int d = -1;
    if (other.triangle >= 0) {
        d = corners_[index(other.triangle)][index(other.corner)];
        if (!is_left(a, d) || !is_left(d, b)) return false;
    }
    const bool fixed = is_fixed(side);
    const auto half = [&](const Side& of) {
        // The triangle p q r with side p q becomes the triangles node r p (in place) and node q r.
        const int k = of.corner;
        const auto outer = beside_[index(of.triangle)];
        const auto was_fixed = fixed_[index(of.triangle)];
        const auto [p0, q] = ends(of);
        const int r = corners_[index(of.triangle)][index(k)];
        const int first = place({node, r, p0}, of.triangle), second = place({node, q, r}, -1);
        join({first, 0}, outer[index(before(k))]);
        fixed_[index(first)][0] = was_fixed[index(before(k))];
        join({second, 0}, outer[index(next(k))]);
        fixed_[index(second)][0] = was_fixed[index(next(k))];
        join({first, 2}, {second, 1});
        fixed_[index(first)][1] = fixed_[index(second)][2] = fixed;
        return std::array<int, 2>{first, second};
    };
    const auto [first, second] = half(side);
    if (d < 0) {
        join({first, 1}, {-1, 0});
        join({second, 2}, {-1, 0});
        return true;
    }
    const auto [third, fourth] = half(other);
    join({first, 1}, {fourth, 2});
    join({second, 2}, {third, 1});
    return true;
}

int UvMesh::insert(int node) {
    const Vec2 p = at[index(node)];
    const Side found = left_at(last_, p);
    if (found.triangle < 0) return -1;
    const auto corners = corners_[index(found.triangle)];
    for (const int corner : corners)
        if (at[index(corner)] == p) return corner;
    last_ = found.triangle;
    for (int k = 0; k < 3; ++k) {
        const auto [a, b] = ends({found.triangle, k});
        if (orient2d(at[index(a)], at[index(b)], p) == 0) return split({found.triangle, k}, node) ? node : -1;
    }
    split_triangle(found.triangle, node);
    return node;
}

bool UvMesh::flip(const Side& side) {
    const Side other = across(side);
    if (other.triangle < 0 || is_fixed(side)) return false;
    const auto [a, b] = ends(side);
    const int c = corners_[index(side.triangle)][index(side.corner)];
    const int d = corners_[index(other.triangle)][index(other.corner)];
    if (orient2d(at[index(a)], at[index(d)], at[index(c)]) <= 0) return false;
    if (orient2d(at[index(d)], at[index(b)], at[index(c)]) <= 0) return false;
    const int k = side.corner, j = other.corner;
    const auto here = beside_[index(side.triangle)], there = beside_[index(other.triangle)];
    const auto fixed_here = fixed_[index(side.triangle)], fixed_there = fixed_[index(other.triangle)];
    // c a b and d b a become c a d and d b c.
    const int first = place({c, a, d}, side.triangle), second = place({d, b, c}, other.triangle);
    join({first, 0}, there[index(next(j))]);
    fixed_[index(first)][0] = fixed_there[index(next(j))];
    join({first, 2}, here[index(before(k))]);
    fixed_[index(first)][2] = fixed_here[index(before(k))];
    join({second, 0}, here[index(next(k))]);
    fixed_[index(second)][0] = fixed_here[index(next(k))];
    join({second, 2}, there[index(before(j))]);
    fixed_[index(second)][2] = fixed_there[index(before(j))];
    join({first, 1}, {second, 1});
    return true;
}

std::vector<int> UvMesh::settle(const std::function<bool(const Side&)>& wants) {
    constexpr std::size_t flips_each = 40;  // on a curved surface, angles may ask for the same flip again and again
    std::vector<int> touched = changed_;
    std::size_t flips = flips_each * (changed_.size() + 4);
    while (!changed_.empty()) {
        const int t = changed_.back();
        changed_.pop_back();
        for (int k = 0; k < 3 && is_here(t); ++k) {
            const Side other = across({t, k});
            if (flips == 0 || other.triangle < 0 || is_fixed({t, k}) || !wants({t, k}) || !flip({t, k})) continue;
            --flips;
            touched.push_back(t);
            touched.push_back(other.triangle);
            break;
        }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    return touched;
}

std::vector<int> UvMesh::settle_all(const std::function<bool(const Side&)>& wants) {
    changed_.clear();
    for (int t = 0; t < triangle_count(); ++t)
        if (is_here(t)) changed_.push_back(t);
    return settle(wants);
}

UvMesh::Side UvMesh::side_of(int a, int b) const {
    const int first = some_[index(a)];
    if (first < 0) return {-1, 0};
    // Goes round the node one way, then the other, because it may be on a border.
    for (const bool forward : {true, false}) {
        int t = first;
        do {
            const auto& corners = corners_[index(t)];
            const int k = static_cast<int>(std::find(corners.begin(), corners.end(), a) - corners.begin());
            if (corners[index(next(k))] == b) return {t, before(k)};
            t = across({t, forward ? next(k) : before(k)}).triangle;
        } while (t >= 0 && t != first);
        if (t >= 0) break;
    }
    return {-1, 0};
}

std::vector<int> UvMesh::around(int node) const {
    std::vector<int> triangles;
    const int first = some_[index(node)];
    int t = first;
    do {
        triangles.push_back(t);
        const auto& corners = corners_[index(t)];
        const int k = static_cast<int>(std::find(corners.begin(), corners.end(), node) - corners.begin());
        t = across({t, next(k)}).triangle;
    } while (t >= 0 && t != first);
    return t == first ? triangles : std::vector<int>();
}

/// The sides that cross the line from a to b, in order. Empty if a node is on the line, or if it leaves the
/// triangles.
std::vector<UvMesh::Side> UvMesh::crossed(int a, int b) const {
    const Vec2 &from = at[index(a)], &to = at[index(b)];
    std::vector<Side> sides;
    for (const int t : around(a)) {
        const auto& corners = corners_[index(t)];
        const int k = static_cast<int>(std::find(corners.begin(), corners.end(), a) - corners.begin());
        const auto [p, q] = ends({t, k});
        if (orient2d(from, to, at[index(p)]) < 0 && orient2d(from, to, at[index(q)]) > 0) sides.push_back({t, k});
    }
    if (sides.size() != 1) return {};
    for (;;) {
        const Side there = across(sides.back());
        if (there.triangle < 0) return {};
        const int apex = corners_[index(there.triangle)][index(there.corner)];
        if (apex == b) return sides;
        const int turn = orient2d(from, to, at[index(apex)]);
        if (turn == 0) return {};
        // The side opposite the end of the last one that is on the apex' side of the line.
        const auto [p, q] = ends(there);
        const int passed = (orient2d(from, to, at[index(p)]) > 0) == (turn > 0) ? p : q;
        const auto& corners = corners_[index(there.triangle)];
        sides.push_back(
            {there.triangle, static_cast<int>(std::find(corners.begin(), corners.end(), passed) - corners.begin())});
    }
}

bool UvMesh::fix(int a, int b) {
    for (std::size_t tries = 0;; ++tries) {
        const Side side = side_of(a, b);
        if (side.triangle >= 0) {
            const Side other = across(side);
            fixed_[index(side.triangle)][index(side.corner)] = true;
            if (other.triangle >= 0) fixed_[index(other.triangle)][index(other.corner)] = true;
            return true;
        }
        const std::vector<Side> sides = crossed(a, b);
        if (sides.empty() || tries > 100 * at.size()) return false;
        // Starts at a different triangle each time, so that two flips cannot undo each other for ever.
        bool flipped = false;
        for (std::size_t i = 0; i < sides.size() && !flipped; ++i) {
            const Side& crossing = sides[(i + 7 * tries) % sides.size()];
            if (is_fixed(crossing)) return false;
            flipped = flip(crossing);
        }
        if (!flipped) return false;
    }
}

void UvMesh::keep_inside() {
    std::vector<bool> outside(corners_.size(), false);
    std::vector<int> open{some_[0]};
    outside[index(some_[0])] = true;
    while (!open.empty()) {
        const int t = open.back();
        open.pop_back();
        for (int k = 0; k < 3; ++k) {
            const Side there = across({t, k});
            if (there.triangle < 0 || is_fixed({t, k}) || outside[index(there.triangle)]) continue;
            outside[index(there.triangle)] = true;
            open.push_back(there.triangle);
        }
    }
    // Crossing a fixed side changes between inside and outside; a hole in the face is outside again.
    std::vector<bool> known = outside;
    std::vector<int> border;
    for (int t = 0; t < triangle_count(); ++t)
        if (outside[index(t)]) border.push_back(t);
    for (std::size_t i = 0; i < border.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const Side there = across({border[i], k});
            if (there.triangle < 0 || known[index(there.triangle)]) continue;
            known[index(there.triangle)] = true;
            outside[index(there.triangle)] = outside[index(border[i])] != is_fixed({border[i], k});
            border.push_back(there.triangle);
        }
    for (int t = 0; t < triangle_count(); ++t) {
        if (!outside[index(t)]) continue;
        for (int k = 0; k < 3; ++k)
            if (const Side there = across({t, k}); there.triangle >= 0) {
                beside_[index(there.triangle)][index(there.corner)] = {-1, 0};
                fixed_[index(there.triangle)][index(there.corner)] = true;
            }
        corners_[index(t)] = {-1, -1, -1};
    }
    std::fill(some_.begin(), some_.end(), -1);
    for (int t = 0; t < triangle_count(); ++t)
        if (is_here(t))
            for (const int node : corners_[index(t)]) some_[index(node)] = t;
}

}  // namespace ripstop::cad
