#include "fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

#include "uv_mesh.h"

namespace ripstop::cad {
namespace {

constexpr double too_long = 1.3;  // relative to its size; its halves are at 0.65
constexpr double growth = 0.5;
constexpr double same_place = 1e-7;  // for vertices that occur in two lines, relative to the face's extent
constexpr int smoothings = 4;
constexpr double most_by_size = 4, free_triangles = 1000;
constexpr int repairs = 12;
constexpr double left_to_sizes = 0.98;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// The angle of a triangle at one corner, as the dot and cross product of its sides there. Two triangles flip
/// their common side if the opposite angles sum to more than half a turn: their cotangents, multiplied out, sum to
/// less than 0.
struct Corner {
    double dot, cross;
};
bool is_flat(const Corner& a, const Corner& b) {
    return a.dot * b.cross + b.dot * a.cross < -1e-9 * (std::abs(a.dot * b.cross) + std::abs(b.dot * a.cross));
}

class Filler {
  public:
    Filler(const TopoDS_Face& face, const std::vector<BorderLoop>& loops, const std::vector<Vec3>& points,
           const FaceSizes& sizes, double most)
        : surface_(face),
          sizes_(sizes),
          mesh_((sizes.low() + sizes.high()).cwiseProduct(sizes.stretch()) / 2,
                (sizes.high() - sizes.low()).cwiseProduct(sizes.stretch()).norm()) {
        for (int i = 0; i < 3; ++i) take(Vec2(0, 0), {Vec3(0, 0, 0), Vec3(0, 0, 0)}, -1);  // the outer triangle
        sound_ = add_borders(loops, points);
        most_ = std::min(most, most_by_size * (sizes.triangles() + static_cast<double>(first_inner_)) + free_triangles);
    }

    bool is_sound() const { return sound_; }

    void refine() {
        std::vector<int> all(index(mesh_.triangle_count()));
        for (int t = 0; t < mesh_.triangle_count(); ++t) all[index(t)] = t;
        enqueue(all);
        // Each new vertex adds two triangles; some are reserved for `repair`.
        const double more = (left_to_sizes * most_ - here()) / 2;
        const std::size_t nodes = mesh_.at.size() + static_cast<std::size_t>(std::max(0.0, more));
        while (!queue_.empty() && mesh_.at.size() < nodes) {
            const Long longest = queue_.top();
            queue_.pop();
            if (is_still(longest.side, longest.ends)) halve(longest.side);
        }
    }

    /// Halves sides that coincide with others in space, or with a point. False if some remain.
    bool repair() {
        for (int round = 0; round < repairs; ++round) {
            const std::vector<std::pair<UvMesh::Side, std::array<int, 2>>> sides = doubled();
            if (sides.empty()) return true;
            bool halved = false;
            for (const auto& [side, ends] : sides)
                if (is_still(side, ends) && !mesh_.is_fixed(side)) halved = halve(side) || halved;
            if (!halved) return false;
            queue_ = {};
        }
        return doubled().empty();
    }

    void smooth() {
        for (int round = 0; round < smoothings; ++round) {
            for (int node = first_inner_; node < static_cast<int>(mesh_.at.size()); ++node) move(node);
            settle_in_space();
        }
    }

    Filled result() const {
        Filled filled;
        for (std::size_t i = index(first_inner_); i < positions_.size(); ++i) filled.inner.push_back(positions_[i]);
        for (int t = 0; t < mesh_.triangle_count(); ++t) {
            if (!mesh_.is_here(t)) continue;
            const std::array<int, 3> corners = in_space(mesh_.corners(t));
            if (is_triangle(corners)) filled.triangles.push_back(corners);
        }
        return filled;
    }

  private:
    struct Long {
        double ratio;
        UvMesh::Side side;
        std::array<int, 2> ends;
        bool operator<(const Long& other) const {
            if (ratio != other.ratio) return ratio < other.ratio;
            return ends < other.ends;
        }
    };

    double here() const {
        double count = 0;
        for (int t = 0; t < mesh_.triangle_count(); ++t) count += mesh_.is_here(t) ? 1 : 0;
        return count;
    }

    /// The nodes as distinct points in space: a vertex of the border, or -1 - i for the i-th inner one.
    std::array<int, 3> in_space(std::array<int, 3> nodes) const {
        for (int& node : nodes) node = node < first_inner_ ? vertices_[index(node)] : first_inner_ - node - 1;
        return nodes;
    }
    static bool is_triangle(const std::array<int, 3>& corners) {
        return corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
    }

    bool is_still(const UvMesh::Side& side, const std::array<int, 2>& ends) const {
        return mesh_.is_here(side.triangle) && mesh_.ends(side) == ends;
    }

    /// The sides that coincide with others in space in the same direction, and those whose ends are one vertex
    /// that is no pole.
    std::vector<std::pair<UvMesh::Side, std::array<int, 2>>> doubled() const {
        std::vector<std::pair<UvMesh::Side, std::array<int, 2>>> sides;
        struct Run {
            std::array<int, 2> ends;
            UvMesh::Side side;
        };
        std::vector<Run> runs;
        for (int t = 0; t < mesh_.triangle_count(); ++t) {
            if (!mesh_.is_here(t)) continue;
            const std::array<int, 3> corners = in_space(mesh_.corners(t));
            for (int k = 0; k < 3; ++k) {
                const UvMesh::Side side{t, k};
                const auto [a, b] = mesh_.ends(side);
                if (a >= first_inner_ && b >= first_inner_) continue;  // inner nodes are in one place only
                const std::array<int, 2> run{corners[index((k + 1) % 3)], corners[index((k + 2) % 3)]};
                if (run[0] == run[1] && !poles_[index(a)]) sides.push_back({side, {a, b}});
                if (is_triangle(corners)) runs.push_back({run, side});
            }
        }
        std::stable_sort(runs.begin(), runs.end(), [](const Run& x, const Run& y) { return x.ends < y.ends; });
        for (std::size_t i = 0; i < runs.size(); ++i)
            if ((i > 0 && runs[i - 1].ends == runs[i].ends) ||
                (i + 1 < runs.size() && runs[i + 1].ends == runs[i].ends))
                sides.push_back({runs[i].side, mesh_.ends(runs[i].side)});
        return sides;
    }

    Vec2 uv(const Vec2& at) const { return at.cwiseQuotient(sizes_.stretch()); }

    struct Place {
        Vec3 position, metric;
    };
    Place place_of(const Vec2& at) const {
        gp_Pnt p;
        gp_Vec du, dv;
        const Vec2 where = uv(at);
        surface_.D1(where[0], where[1], p, du, dv);
        du /= sizes_.stretch()[0];
        dv /= sizes_.stretch()[1];
        return {{p.X(), p.Y(), p.Z()}, {du.Dot(du), du.Dot(dv), dv.Dot(dv)}};
    }

    /// Evaluates the surface at the next node.
    void take(const Vec2& at, const Place& place, int vertex, bool pole = false) {
        positions_.push_back(place.position);
        metrics_.push_back(place.metric);
        vertices_.push_back(vertex);
        poles_.push_back(pole);
        wanted_.push_back(sizes_.at(uv(at)));
    }

    bool add_borders(const std::vector<BorderLoop>& loops, const std::vector<Vec3>& points) {
        std::vector<std::vector<int>> lines;
        std::map<int, std::vector<int>> nodes;  // of each vertex
        const double noise = same_place * (sizes_.high() - sizes_.low()).cwiseProduct(sizes_.stretch()).norm();
        for (const BorderLoop& loop : loops) {
            std::vector<int>& line = lines.emplace_back();
            for (const BorderNode& node : loop) {
                Vec2 at = node.uv.cwiseProduct(sizes_.stretch());
                for (const int other : nodes[node.vertex])
                    if ((mesh_.at[index(other)] - at).norm() < noise) at = mesh_.at[index(other)];
                const int added = mesh_.add(at), inserted = mesh_.insert(added);
                if (inserted == added) {
                    take(at, {points[index(node.vertex)], place_of(at).metric}, node.vertex, node.pole);
                    nodes[node.vertex].push_back(added);
                    mesh_.settle([this](const UvMesh::Side& side) { return is_flat_in_plane(side); });
                } else {  // two lines may touch in a vertex
                    if (inserted < 0 || vertices_[index(inserted)] != node.vertex) return false;
                    mesh_.drop_last();
                }
                line.push_back(inserted);
            }
        }
        first_inner_ = static_cast<int>(mesh_.at.size());
        for (const std::vector<int>& line : lines)
            for (std::size_t i = 0; i < line.size(); ++i) {
                const int a = line[i], b = line[(i + 1) % line.size()];
                const UvMesh::Side before = mesh_.side_of(a, b);
                if (a == b || (before.triangle >= 0 && mesh_.is_fixed(before))) return false;  // there and back
                if (!mesh_.fix(a, b)) return false;
            }
        mesh_.keep_inside();
        size_borders(lines);
        mesh_.settle([this](const UvMesh::Side& side) { return is_flat_on_surface(side); });
        return true;
    }

    /// Triangles at a border are as small as its pieces.
    void size_borders(const std::vector<std::vector<int>>& lines) {
        for (const std::vector<int>& line : lines) {
            std::vector<double> lengths;
            for (std::size_t i = 0; i < line.size(); ++i)
                lengths.push_back((positions_[index(line[i])] - positions_[index(line[(i + 1) % line.size()])]).norm());
            for (std::size_t i = 0; i < line.size(); ++i) {
                const double before = lengths[(i + line.size() - 1) % line.size()], after = lengths[i];
                double& wanted = wanted_[index(line[i])];
                if (before > 0 && after > 0) wanted = std::min(wanted, (before + after) / 2);
            }
        }
    }

    Corner corner_in_plane(int apex, int a, int b) const {
        const Vec2 p = mesh_.at[index(a)] - mesh_.at[index(apex)], q = mesh_.at[index(b)] - mesh_.at[index(apex)];
        return {p.dot(q), p[0] * q[1] - p[1] * q[0]};
    }

    Corner corner_on_surface(int apex, int a, int b, const Vec3& metric) const {
        const Vec2 p = mesh_.at[index(a)] - mesh_.at[index(apex)], q = mesh_.at[index(b)] - mesh_.at[index(apex)];
        return {metric[0] * p[0] * q[0] + metric[1] * (p[0] * q[1] + p[1] * q[0]) + metric[2] * p[1] * q[1],
                p[0] * q[1] - p[1] * q[0]};
    }

    Corner corner_in_space(int apex, int a, int b) const {
        const Vec3 p = positions_[index(a)] - positions_[index(apex)],
                   q = positions_[index(b)] - positions_[index(apex)];
        return {p.dot(q), p.cross(q).norm()};
    }

    /// The ends a, b of a side between two triangles and the corners c, d opposite it, as a b c d.
    std::array<int, 4> around(const UvMesh::Side& side) const {
        const UvMesh::Side other = mesh_.across(side);
        const auto [a, b] = mesh_.ends(side);
        return {a, b, mesh_.corners(side.triangle)[index(side.corner)],
                mesh_.corners(other.triangle)[index(other.corner)]};
    }

    bool is_flat_in_plane(const UvMesh::Side& side) const {
        const auto [a, b, c, d] = around(side);
        return is_flat(corner_in_plane(c, a, b), corner_in_plane(d, b, a));
    }

    bool is_flat_on_surface(const UvMesh::Side& side) const {
        const auto [a, b, c, d] = around(side);
        const Vec3 metric = (metrics_[index(a)] + metrics_[index(b)] + metrics_[index(c)] + metrics_[index(d)]) / 4;
        return is_flat(corner_on_surface(c, a, b, metric), corner_on_surface(d, b, a, metric));
    }

    bool is_flat_in_space(const UvMesh::Side& side) const {
        const auto [a, b, c, d] = around(side);
        return is_flat(corner_in_space(c, a, b), corner_in_space(d, a, b));
    }

    void settle_in_space() {
        mesh_.settle_all([this](const UvMesh::Side& side) { return is_flat_in_space(side); });
    }

    double length(int a, int b) const {
        const Vec2 d = mesh_.at[index(b)] - mesh_.at[index(a)];
        const auto along = [&d](const Vec3& metric) {
            return std::sqrt(
                std::max(0.0, metric[0] * d[0] * d[0] + 2 * metric[1] * d[0] * d[1] + metric[2] * d[1] * d[1]));
        };
        return std::max((along(metrics_[index(a)]) + along(metrics_[index(b)])) / 2,
                        (positions_[index(a)] - positions_[index(b)]).norm());
    }

    void enqueue(const std::vector<int>& triangles) {
        for (const int t : triangles)
            for (int k = 0; k < 3 && mesh_.is_here(t); ++k) {
                const UvMesh::Side side{t, k};
                if (mesh_.is_fixed(side) || mesh_.across(side).triangle < 0) continue;
                const auto [a, b] = mesh_.ends(side);
                const double between = sizes_.at(uv((mesh_.at[index(a)] + mesh_.at[index(b)]) / 2));
                const double size = std::min((wanted_[index(a)] + wanted_[index(b)]) / 2, between);
                if (const double ratio = length(a, b) / size; ratio > too_long) queue_.push({ratio, side, {a, b}});
            }
    }

    /// Halves a side between two triangles. False if that would give a triangle that does not turn left.
    bool halve(const UvMesh::Side& side) {
        const std::array<int, 4> others = around(side);
        const Vec2 middle = (mesh_.at[index(others[0])] + mesh_.at[index(others[1])]) / 2;
        const int node = mesh_.add(middle);
        if (!mesh_.split(side, node)) {
            mesh_.drop_last();
            return false;
        }
        take(middle, place_of(middle), -1);
        for (const int other : others)
            wanted_.back() = std::min(
                wanted_.back(), wanted_[index(other)] + growth * (positions_[index(other)] - positions_.back()).norm());
        enqueue(mesh_.settle([this](const UvMesh::Side& it) { return is_flat_on_surface(it); }));
        return true;
    }

    /// The lowest quality of these triangles in space: 1 for an equilateral one, 0 for a degenerate one.
    double worst(const std::vector<int>& triangles) const {
        double least = 1;
        for (const int t : triangles) {
            const auto [i, j, k] = mesh_.corners(t);
            const Vec3 a = positions_[index(i)], b = positions_[index(j)], c = positions_[index(k)];
            const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
            least = std::min(least, squares > 0 ? 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / squares : 0);
        }
        return least;
    }

    void move(int node) {
        const std::vector<int> star = mesh_.around(node);
        if (star.empty()) return;
        Vec2 sum(0, 0);
        for (const int t : star)
            for (const int other : mesh_.corners(t)) {
                if (other == node) continue;
                if (poles_[index(other)]) return;  // a pole has several places, so their mean is meaningless
                sum += mesh_.at[index(other)] / 2;
            }
        const double before = worst(star);
        const Vec2 from = mesh_.at[index(node)];
        const Vec3 position = positions_[index(node)];
        mesh_.at[index(node)] = sum / static_cast<double>(star.size());
        const bool turns = std::all_of(star.begin(), star.end(), [this](int t) { return mesh_.turns_left(t); });
        if (turns) {
            positions_[index(node)] = place_of(mesh_.at[index(node)]).position;
            if (worst(star) >= std::min(before, 0.7)) return;
        }
        mesh_.at[index(node)] = from;
        positions_[index(node)] = position;
    }

    BRepAdaptor_Surface surface_;
    const FaceSizes& sizes_;
    UvMesh mesh_;
    std::vector<Vec3> positions_, metrics_;  // a metric: E, F, G at the node's place in the plane
    std::vector<int> vertices_;
    std::vector<bool> poles_;
    std::vector<double> wanted_;
    std::priority_queue<Long> queue_;
    double most_ = 0;
    int first_inner_ = 0;
    bool sound_ = false;
};

}  // namespace

std::optional<Filled> filled(const TopoDS_Face& face, const std::vector<BorderLoop>& loops,
                             const std::vector<Vec3>& points, const FaceSizes& sizes, double most) {
    Filler filler(face, loops, points, sizes, most);
    if (!filler.is_sound()) return {};
    filler.refine();
    filler.smooth();
    if (!filler.repair()) return {};
    return filler.result();
}

}  // namespace ripstop::cad
