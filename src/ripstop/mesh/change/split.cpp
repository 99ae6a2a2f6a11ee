#include "ripstop/mesh/change/split.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"

namespace ripstop {
namespace {

using Corner = SplitVertex;
using Piece = std::vector<Corner>;  // a triangle or quadrilateral, counter-clockwise

Eigen::VectorXd snapped(const TriangleMesh& mesh, const Eigen::VectorXd& field, double snap) {
    Eigen::VectorXd result = field;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
            if (!(field[a] * field[b] < 0)) continue;
            const double share = field[a] / (field[a] - field[b]);
            if (share < snap) result[a] = 0;
            if (share > 1 - snap) result[b] = 0;
        }
    return result;
}

/// The point where the line crosses an edge, bit for bit the same from both triangles.
Corner crossing(int u, int v, const Eigen::VectorXd& field) {
    const int a = std::min(u, v), b = std::max(u, v);
    return {a, b, field[a] / (field[a] - field[b])};
}

Vec3 position(const TriangleMesh& mesh, const Corner& at) {
    const Vec3 a = mesh.positions.row(at.a), b = mesh.positions.row(at.b);
    return a + at.share * (b - a);
}

/// The part of triangle t where the field has this sign; empty if there is none.
Piece part_of_triangle(const TriangleMesh& mesh, int t, const Eigen::VectorXd& field, double sign) {
    Piece piece;
    bool inside = false;
    for (int k = 0; k < 3; ++k) {
        const int u = mesh.triangles(t, k), v = mesh.triangles(t, (k + 1) % 3);
        if (sign * field[u] >= 0) piece.push_back({u, u, 0});
        inside = inside || sign * field[u] > 0;
        if (field[u] * field[v] < 0) piece.push_back(crossing(u, v, field));
    }
    return inside ? piece : Piece();
}

/// Collects the triangles of one half and numbers its vertices.
class Half {
  public:
    explicit Half(const TriangleMesh& mesh) : mesh_(mesh) {}

    void add(const Piece& piece) {
        if (piece.size() == 3) triangles_.push_back({number(piece[0]), number(piece[1]), number(piece[2])});
        if (piece.size() != 4) return;
        // The shorter diagonal gives better triangles.
        const auto length = [&](std::size_t i, std::size_t k) {
            return (position(mesh_, piece[i]) - position(mesh_, piece[k])).squaredNorm();
        };
        const std::size_t i = length(0, 2) <= length(1, 3) ? 0 : 1;
        triangles_.push_back({number(piece[i]), number(piece[i + 1]), number(piece[i + 2])});
        triangles_.push_back({number(piece[i]), number(piece[i + 2]), number(piece[(i + 3) % 4])});
    }

    MeshHalf finish() const {
        MeshHalf half;
        half.source = source_;
        half.mesh.positions.resize(static_cast<Eigen::Index>(source_.size()), 3);
        for (std::size_t v = 0; v < source_.size(); ++v)
            half.mesh.positions.row(static_cast<Eigen::Index>(v)) = position(mesh_, source_[v]).transpose();
        half.mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            half.mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles_[t][0], triangles_[t][1],
                triangles_[t][2];
        return half;
    }

  private:
    int number(const Corner& corner) {
        const auto [at, is_new] = numbers_.try_emplace({corner.a, corner.b}, static_cast<int>(source_.size()));
        if (is_new) source_.push_back(corner);
        return at->second;
    }

    const TriangleMesh& mesh_;
    std::map<std::array<int, 2>, int> numbers_;
    std::vector<SplitVertex> source_;
    std::vector<std::array<int, 3>> triangles_;
};

bool find_boundary(MeshHalf& half) {
    if (half.mesh.triangle_count() == 0) return false;
    try {
        half.boundary =
            require_disk(half.mesh, Adjacency(half.mesh.triangles, half.mesh.vertex_count()), "half of a tile");
    } catch (const InputError&) {
        return false;
    }
    return true;
}

using EdgeKey = std::array<int, 4>;

EdgeKey key(const MeshHalf& half, int u, int v) {
    const SplitVertex& from = half.source[at(u)];
    const SplitVertex& to = half.source[at(v)];
    return {from.a, from.b, to.a, to.b};
}

/// The boundary run that a half shares with the other half, which has it in reverse; empty unless it is a single run.
std::vector<int> common_run(const MeshHalf& half, const MeshHalf& other) {
    std::set<EdgeKey> theirs;
    const std::size_t m = other.boundary.size(), n = half.boundary.size();
    for (std::size_t i = 0; i < m; ++i) theirs.insert(key(other, other.boundary[(i + 1) % m], other.boundary[i]));
    std::vector<bool> common(n);
    for (std::size_t i = 0; i < n; ++i)
        common[i] = theirs.count(key(half, half.boundary[i], half.boundary[(i + 1) % n])) > 0;
    std::size_t start = n, runs = 0;
    for (std::size_t i = 0; i < n; ++i)
        if (common[i] && !common[(i + n - 1) % n]) {
            start = i;
            ++runs;
        }
    if (runs != 1) return {};
    std::vector<int> run{half.boundary[start]};
    for (std::size_t i = start; common[i % n]; ++i) run.push_back(half.boundary[(i + 1) % n]);
    return run;
}

}  // namespace

std::optional<MeshSplit> split_mesh(const TriangleMesh& mesh, const Eigen::VectorXd& field, double snap) {
    const Eigen::VectorXd values = snapped(mesh, field, snap);
    Half left(mesh), right(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Piece above = part_of_triangle(mesh, t, values, 1), below = part_of_triangle(mesh, t, values, -1);
        left.add(above);
        right.add(below);
        if (!above.empty() || !below.empty()) continue;
        // The snapped triangle lies on the line entirely: its unsnapped mean decides the side.
        const double mean = field[mesh.triangles(t, 0)] + field[mesh.triangles(t, 1)] + field[mesh.triangles(t, 2)];
        const auto corner = [&](int k) { return Corner{mesh.triangles(t, k), mesh.triangles(t, k), 0}; };
        (mean >= 0 ? left : right).add({corner(0), corner(1), corner(2)});
    }
    MeshSplit split{left.finish(), right.finish()};
    if (!find_boundary(split.left) || !find_boundary(split.right)) return std::nullopt;
    split.left.cut = common_run(split.left, split.right);
    split.right.cut = common_run(split.right, split.left);
    std::reverse(split.right.cut.begin(), split.right.cut.end());
    if (split.left.cut.empty() || split.right.cut.size() != split.left.cut.size()) return std::nullopt;
    return split;
}

}  // namespace ripstop
