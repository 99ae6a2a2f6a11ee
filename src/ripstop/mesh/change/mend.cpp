#include "ripstop/mesh/change/mend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/base/union_find.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/change/coincident.h"
#include "ripstop/mesh/disk.h"

namespace ripstop {
namespace {

constexpr double no_edge = 1e-9;    // relative to a triangle's longest edge: shorter edges count as one place
constexpr double no_height = 1e-6;  // relative to the longest edge: a corner lower than this lies on it
constexpr double inside = 1e-3;     // relative to the longest edge: least distance of that corner from the ends
constexpr int most_rounds = 50;     // limit for needles that become needles again
constexpr double tip_angle = 150 * degree;
constexpr double tip_defect = 10 * degree;
constexpr double narrower = 0.999;  // factor on the width: tips of exactly that width are all kept, whatever their
                                    // rounding

bool is_disk(const TriangleMesh& mesh) {
    try {
        require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), "");
        return true;
    } catch (const InputError&) {
        return false;
    }
}

/// The edge over which a triangle has no height; -1 if there is none.
int needle_edge(const TriangleMesh& mesh, int triangle) {
    for (int k = 0; k < 3; ++k) {
        const Vec3 a = mesh.corner(triangle, k), along = mesh.corner(triangle, (k + 1) % 3) - a;
        const Vec3 to = mesh.corner(triangle, (k + 2) % 3) - a;
        const double length = along.norm(), place = to.dot(along) / (length * length);
        if (!(length > 0) || place < inside || place > 1 - inside) continue;
        if (to.cross(along).norm() / length <= no_height * length) return k;
    }
    return -1;
}

bool has_needle(const TriangleMesh& mesh) {
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (needle_edge(mesh, t) >= 0) return true;
    return false;
}

MendedMesh as_given(const TriangleMesh& mesh) {
    MendedMesh result{mesh, std::vector<int>(static_cast<std::size_t>(mesh.vertex_count())),
                      std::vector<int>(static_cast<std::size_t>(mesh.triangle_count()))};
    std::iota(result.vertex.begin(), result.vertex.end(), 0);
    std::iota(result.triangle.begin(), result.triangle.end(), 0);
    result.becomes = result.vertex;
    return result;
}

void note(MendedMesh& mended, int& count, const Vec3& place) {
    if (!mended.any()) mended.place = place;
    ++count;
}

/// Keeps the triangles for which `stays` holds.
template <class Stays>
void keep_triangles(MendedMesh& mended, Stays&& stays) {
    Eigen::Index kept = 0;
    for (int t = 0; t < mended.mesh.triangle_count(); ++t) {
        if (!stays(t)) continue;
        mended.mesh.triangles.row(kept) = mended.mesh.triangles.row(t).eval();
        mended.triangle[at(kept++)] = mended.triangle[at(t)];
    }
    mended.mesh.triangles.conservativeResize(kept, 3);
    mended.triangle.resize(static_cast<std::size_t>(kept));
}

/// Replaces each vertex by the first of its set and removes triangles that then use a vertex twice.
void join(MendedMesh& mended, UnionFind& joined) {
    for (int& v : mended.mesh.triangles.reshaped<Eigen::RowMajor>()) v = joined.root(v);
    for (int& v : mended.becomes) v = joined.root(v);
    keep_triangles(mended, [&](int t) {
        const auto row = mended.mesh.triangles.row(t);
        const bool stays = row[0] != row[1] && row[1] != row[2] && row[2] != row[0];
        if (!stays) note(mended, mended.flat, mended.mesh.positions.row(row[0]));
        return stays;
    });
}

void join_short_edges(MendedMesh& mended) {
    const TriangleMesh& mesh = mended.mesh;
    UnionFind joined(at(mesh.vertex_count()));
    bool any = false;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        double longest = 0;
        for (int k = 0; k < 3; ++k)
            longest = std::max(longest, (mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)).norm());
        for (int k = 0; k < 3; ++k) {
            const int from = mesh.triangles(t, k), to = mesh.triangles(t, (k + 1) % 3);
            if ((mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)).norm() > no_edge * longest) continue;
            any = true;
            if (joined.join(from, to)) note(mended, mended.joined, mesh.corner(t, k));
        }
    }
    if (any) join(mended, joined);
}

void join_places(MendedMesh& mended) {
    const std::vector<int> first = first_in_place(mended.mesh.positions);
    UnionFind joined(at(mended.mesh.vertex_count()));
    for (std::size_t v = 0; v < first.size(); ++v)
        if (joined.join(static_cast<int>(v), first[v]))
            note(mended, mended.joined, mended.mesh.positions.row(static_cast<Eigen::Index>(v)));
    join(mended, joined);
}

void drop_doubled(MendedMesh& mended) {
    std::set<std::array<int, 3>> seen;
    keep_triangles(mended, [&](int t) {
        std::array<int, 3> corners;
        for (int k = 0; k < 3; ++k) corners[at(k)] = mended.mesh.triangles(t, k);
        std::sort(corners.begin(), corners.end());
        const bool is_new = seen.insert(corners).second;
        if (!is_new) note(mended, mended.doubled, mended.mesh.corner(t, 0));
        return is_new;
    });
}

bool joins(const Adjacency& adjacency, int a, int b) {
    const auto leads = [&](int from, int to) {
        for (const int h : adjacency.outgoing(from))
            if (adjacency.to(h) == to) return true;
        return false;
    };
    return leads(a, b) || leads(b, a);
}

/// Mends needles that do not touch each other. Returns true if there was one.
bool mend_needles_once(MendedMesh& mended) {
    TriangleMesh& mesh = mended.mesh;
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    std::vector<bool> touched(static_cast<std::size_t>(mesh.vertex_count()), false);
    std::vector<bool> gone(static_cast<std::size_t>(mesh.triangle_count()), false);
    bool any = false;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const int k = needle_edge(mesh, t);
        if (k < 0) continue;
        const int h = 3 * t + k, twin = adjacency.twin(h);
        const int a = adjacency.from(h), b = adjacency.to(h), c = adjacency.opposite(h);
        const int d = twin >= 0 ? adjacency.opposite(twin) : c;
        if (twin >= 0 && (c == d || joins(adjacency, c, d))) continue;
        std::array<int, 4> round{a, b, c, d};
        if (std::any_of(round.begin(), round.end(), [&](int v) { return touched[at(v)]; })) continue;
        for (const int v : round) touched[at(v)] = true;
        note(mended, mended.flat, mesh.positions.row(c));
        any = true;
        if (twin < 0) {
            gone[at(t)] = true;
            continue;
        }
        const int beyond = Adjacency::triangle(twin);
        mesh.triangles.row(t) << c, a, d;
        mesh.triangles.row(beyond) << d, b, c;
        mended.triangle[at(t)] = mended.triangle[at(beyond)];
    }
    if (any) keep_triangles(mended, [&](int t) { return !gone[at(t)]; });
    return any;
}

void drop_unused_vertices(MendedMesh& mended) {
    std::vector<int> number(mended.vertex.size(), -1);
    for (const int v : mended.mesh.triangles.reshaped<Eigen::RowMajor>()) number[at(v)] = 0;
    int count = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        mended.mesh.positions.row(count) = mended.mesh.positions.row(static_cast<Eigen::Index>(v)).eval();
        mended.vertex[at(count)] = mended.vertex[v];
        number[v] = count++;
    }
    mended.mesh.positions.conservativeResize(count, 3);
    mended.vertex.resize(static_cast<std::size_t>(count));
    for (int& v : mended.mesh.triangles.reshaped<Eigen::RowMajor>()) v = number[at(v)];
    for (int& v : mended.becomes) v = number[at(v)];
}

void count_unused(MendedMesh& mended) {
    std::vector<bool> used(mended.vertex.size(), false);
    for (const int v : mended.mesh.triangles.reshaped<Eigen::RowMajor>()) used[at(v)] = true;
    for (std::size_t v = 0; v < used.size(); ++v)
        if (!used[v]) note(mended, mended.unused, mended.mesh.positions.row(static_cast<Eigen::Index>(v)));
}

MendedMesh mended_of(const TriangleMesh& mesh, bool all_places) {
    MendedMesh mended = as_given(mesh);
    count_unused(mended);
    join_short_edges(mended);
    if (all_places) join_places(mended);
    drop_doubled(mended);
    for (int round = 0; round < most_rounds && mend_needles_once(mended); ++round) {
    }
    drop_unused_vertices(mended);
    return mended;
}

/// The sum of the triangle angles at each vertex.
std::vector<double> angle_sums(const TriangleMesh& mesh) {
    std::vector<double> angle(static_cast<std::size_t>(mesh.vertex_count()), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k)
            angle[at(mesh.triangles(t, k))] +=
                angle_at(mesh.corner(t, k), mesh.corner(t, (k + 1) % 3), mesh.corner(t, (k + 2) % 3));
    return angle;
}

/// Applies the changes of tips in `tips` to a disk that was mended before.
void take_tips(MendedMesh& mended, MendedMesh&& tips) {
    if (!tips.any()) return;
    if (!mended.any()) mended.place = tips.place;
    mended.welded += tips.welded;
    mended.closed += tips.closed;
    for (int& v : tips.vertex) v = mended.vertex[at(v)];
    for (int& t : tips.triangle) t = mended.triangle[at(t)];
    for (int& v : mended.becomes) v = v < 0 ? v : tips.becomes[at(v)];
    mended.vertex = std::move(tips.vertex);
    mended.triangle = std::move(tips.triangle);
    mended.mesh = std::move(tips.mesh);
}

}  // namespace

MendedMesh mend_mesh(const TriangleMesh& mesh, const MendOptions& options) {
    const bool sound = is_disk(mesh);
    MendedMesh mended = sound && !has_needle(mesh) ? as_given(mesh) : mended_of(mesh, false);
    if (!is_disk(mended.mesh)) {
        if (sound || mended.mesh.triangle_count() == 0) return as_given(mesh);
        MendedMesh joined = mended_of(mesh, true);
        if (!is_disk(joined.mesh)) return mended;
        mended = std::move(joined);
    }
    if (options.keep_tips) return mended;
    take_tips(mended, weld_tips(mended.mesh));
    if (options.tip_width > 0) take_tips(mended, close_tips(mended.mesh, options.tip_width));
    return mended;
}

MendedMesh weld_tips(const TriangleMesh& mesh) {
    const Adjacency adjacency(mesh.triangles, mesh.vertex_count());
    const std::vector<std::vector<int>> loops = boundary_loops(adjacency);
    const std::vector<double> angle = angle_sums(mesh);
    const std::vector<int>& loop = loops.front();
    const std::size_t count = loop.size();
    const auto at = [&](std::size_t i) -> Vec3 { return mesh.positions.row(loop[i % count]); };
    const auto angle_of = [&](std::size_t i) { return angle[static_cast<std::size_t>(loop[i % count])]; };
    const auto cracked = [&](std::size_t i) {  // an open edge pair at i whose tip is vertex i + 1
        const double edge = std::min((at(i + 1) - at(i)).norm(), (at(i + 2) - at(i + 1)).norm());
        return (at(i + 2) - at(i)).norm() <= no_height * edge;
    };
    MendedMesh mended = as_given(mesh);
    UnionFind joined(static_cast<std::size_t>(mesh.vertex_count()));
    for (std::size_t i = 0; i < count; ++i) {
        if (!cracked(i) || cracked(i + count - 2)) continue;  // continue only at the first crack of a tip
        std::size_t last = i;
        double sum = angle_of(i);
        bool flat = true;
        for (; cracked(last) && last < i + count; last += 2) {
            sum += angle_of(last + 2);
            flat = flat && std::abs(angle_of(last + 1) - 2 * std::numbers::pi) <= tip_defect;
        }
        if (last + 2 >= i + count || sum >= tip_angle || !flat) continue;
        for (std::size_t k = i; k < last; k += 2)
            if (joined.join(loop[k % count], loop[(k + 2) % count])) note(mended, mended.welded, at(k));
    }
    if (mended.welded == 0) return mended;
    join(mended, joined);
    drop_unused_vertices(mended);
    return is_disk(mended.mesh) ? mended : as_given(mesh);
}

MendedMesh close_tips(const TriangleMesh& mesh, double width) {
    const std::vector<int> loop = boundary_loops(Adjacency(mesh.triangles, mesh.vertex_count())).front();
    const std::vector<double> angle = angle_sums(mesh);
    const std::size_t count = loop.size();
    const auto vertex = [&](std::size_t i) { return static_cast<std::size_t>(loop[i % count]); };
    const auto edge = [&](std::size_t i) -> Vec3 {
        return mesh.positions.row(loop[(i + 1) % count]) - mesh.positions.row(loop[i % count]);
    };
    MendedMesh mended = as_given(mesh);
    UnionFind joined(at(mesh.vertex_count()));
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 before = edge(i + count - 1);
        std::size_t end = i;
        double length = 0, angles = angle[vertex(i)];
        const double most = std::min(narrower * width, before.norm() / 10);
        for (; end < i + count - 3 && length + edge(end).norm() <= most; ++end) {
            length += edge(end).norm();
            angles += angle[vertex(end + 1)];
        }
        if (end == i || 10 * length > edge(end).norm()) continue;
        const bool turns_left = angles < static_cast<double>(end - i + 1) * std::numbers::pi;
        if (!turns_left || before.dot(edge(end)) >= 0) continue;
        for (std::size_t k = i + 1; k <= end; ++k) joined.join(loop[k % count], loop[i % count]);
        note(mended, mended.closed, mesh.positions.row(loop[i % count]));
        mended.mesh.positions.row(joined.root(loop[i % count])) =
            (mesh.positions.row(loop[i % count]) + mesh.positions.row(loop[end % count])) / 2;
    }
    if (mended.closed == 0) return mended;
    join(mended, joined);
    drop_unused_vertices(mended);
    mended.flat = 0;  // its triangles were removed with the tip
    return is_disk(mended.mesh) ? mended : as_given(mesh);
}

}  // namespace ripstop
