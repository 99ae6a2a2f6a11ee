#include "ripstop/flatten/tools/laying.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/change/flips.h"

namespace ripstop {
namespace {

double flat_area(const TriangleMesh& mesh, const Points2& positions, int triangle) {
    const auto& corners = mesh.triangles.row(triangle);
    return signed_area(positions.row(corners[0]), positions.row(corners[1]), positions.row(corners[2]));
}

/// The objective of a repair at a vertex: `fewer` counts its flipped triangles, `less_bad` takes the worst ratio of
/// flat to true area, negated. Counting alone gets stuck in folds; the worst ratio alone spreads them.
enum class Aim { fewer, less_bad };

using Badness = std::pair<int, double>;
Badness badness(const TriangleMesh& mesh, const Points2& positions, const std::vector<int>& outgoing, Aim aim) {
    Badness bad{0, -std::numeric_limits<double>::infinity()};
    for (const int h : outgoing) {
        const double ratio = flat_area(mesh, positions, h / 3) / triangle_area(mesh, h / 3);
        bad.first += aim == Aim::fewer && !(ratio > 0);
        bad.second = std::max(bad.second, -ratio);
    }
    return bad;
}

/// Moves `vertex` to the best of a few trial places. Returns whether one was better than its present place.
bool improve(const TriangleMesh& mesh, const std::vector<int>& outgoing, int vertex, Aim aim, Points2& positions) {
    Vec2 laid = Vec2::Zero();
    Vec2 middle = Vec2::Zero();
    double total = 0;
    for (const int h : outgoing) {
        const int t = h / 3;
        const double area = triangle_area(mesh, t);
        laid += area * laid_on(mesh, positions, t, h % 3);
        middle += area / 2 * positions.row(mesh.triangles(t, (h + 1) % 3)).transpose();
        middle += area / 2 * positions.row(mesh.triangles(t, (h + 2) % 3)).transpose();
        total += area;
    }
    const Vec2 old = positions.row(vertex);
    Vec2 best = old;
    Badness least = badness(mesh, positions, outgoing, aim);
    bool moved = false;
    for (const Vec2& target : {Vec2(laid / total), Vec2(middle / total)})
        for (const double part : {1.0, 0.5, 0.25}) {
            positions.row(vertex) = (old + part * (target - old)).transpose();
            const Badness bad = badness(mesh, positions, outgoing, aim);
            if (bad >= Badness{least.first, least.second - 1e-9}) continue;
            least = bad;
            best = positions.row(vertex);
            moved = true;
        }
    positions.row(vertex) = best.transpose();
    return moved;
}

}  // namespace

Vec2 laid_on(const TriangleMesh& mesh, const Points2& positions, int triangle, int k) {
    const int a = (k + 1) % 3;
    const int b = (k + 2) % 3;
    const Mat22 rest = lay_flat(mesh.corner(triangle, a), mesh.corner(triangle, b), mesh.corner(triangle, k));
    const Vec2 p = positions.row(mesh.triangles(triangle, a));
    const Vec2 q = positions.row(mesh.triangles(triangle, b));
    const double length = (q - p).norm();
    const Vec2 along = length > 0 ? Vec2((q - p) / length) : Vec2(Vec2::UnitX());
    const Vec2 up(-along.y(), along.x());
    return 0.5 * (p + q) + (rest(0, 1) - 0.5 * rest(0, 0)) * along + rest(1, 1) * up;
}

void lay_first(const TriangleMesh& mesh, int triangle, Points2& positions) {
    const Mat22 flat = lay_flat(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
    positions.row(mesh.triangles(triangle, 0)).setZero();
    for (int k = 1; k < 3; ++k) positions.row(mesh.triangles(triangle, k)) = flat.col(k - 1).transpose();
}

int lay_on_missing(const TriangleMesh& mesh, int seed, std::vector<bool> placed, Points2& positions) {
    const auto is_placed = [&](int v) { return placed[at(v)]; };
    const auto missing = [&] { return static_cast<int>(std::count(placed.begin(), placed.end(), false)); };
    const int before = missing();
    // Laying needs at least one placed edge to start from.
    bool started = false;
    for (int t = 0; t < mesh.triangle_count() && !started; ++t)
        started =
            is_placed(mesh.triangles(t, 0)) + is_placed(mesh.triangles(t, 1)) + is_placed(mesh.triangles(t, 2)) >= 2;
    if (!started) {
        lay_first(mesh, seed, positions);
        std::fill(placed.begin(), placed.end(), false);
        for (int k = 0; k < 3; ++k) placed[at(mesh.triangles(seed, k))] = true;
    }
    bool grows = true;
    while (grows) {
        grows = false;
        Points2 sum = Points2::Zero(mesh.vertex_count(), 2);
        Eigen::VectorXd weight = Eigen::VectorXd::Zero(mesh.vertex_count());
        for (int t = 0; t < mesh.triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) {
                const int v = mesh.triangles(t, k);
                if (is_placed(v) || !is_placed(mesh.triangles(t, (k + 1) % 3)) ||
                    !is_placed(mesh.triangles(t, (k + 2) % 3)))
                    continue;
                const double area = triangle_area(mesh, t);
                sum.row(v) += area * laid_on(mesh, positions, t, k).transpose();
                weight[v] += area;
            }
        for (int v = 0; v < mesh.vertex_count(); ++v) {
            if (weight[v] == 0) continue;
            positions.row(v) = sum.row(v) / weight[v];
            placed[at(v)] = true;
            grows = true;
        }
    }
    return before - missing();
}

int repair_flipped_triangles(const TriangleMesh& mesh, const Adjacency& adjacency, int passes, Points2& positions) {
    Points2 best = positions;
    int fewest = count_flipped(mesh.triangles, positions);
    bool moved = true;
    for (int pass = 0; pass < passes && fewest > 0 && moved; ++pass) {
        std::vector<int> concerned;
        for (int t = 0; t < mesh.triangle_count(); ++t)
            if (!(flat_area(mesh, positions, t) > 0))
                for (int k = 0; k < 3; ++k) concerned.push_back(mesh.triangles(t, k));
        std::sort(concerned.begin(), concerned.end());
        concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
        moved = false;
        for (const Aim aim : {Aim::less_bad, Aim::fewer})
            for (const int v : concerned) moved = improve(mesh, adjacency.outgoing(v), v, aim, positions) || moved;
        const int count = count_flipped(mesh.triangles, positions);
        if (count >= fewest) continue;
        fewest = count;
        best = positions;
    }
    positions = best;
    return fewest;
}

}  // namespace ripstop
