#include "ripstop/measure/equal_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "ripstop/base/index.h"
#include "ripstop/geometry/triangle.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/targets.h"

namespace ripstop {
namespace {

constexpr double same_place = 1e-9;   // [m]: within this a flattening of one tile is valid for the other too
constexpr double same_strain = 1e-8;  // rounding of an inflated shape, a hundred thousandth of what matters for cutting
constexpr int points_a_chain = 32;

/// Properties of a tile that do not depend on its position.
struct Signature {
    double area = 0, perimeter = 0;
    std::vector<double> chains;  ///< target length of each chain on the cloth [m]
};

/// The index of each vertex in the boundary (#V), -1 for interior vertices.
std::vector<int> places_of(const Tile& tile) {
    std::vector<int> places(static_cast<std::size_t>(tile.mesh.vertex_count()), -1);
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) places[at(tile.boundary[i])] = static_cast<int>(i);
    return places;
}

Signature signature_of(const Tile& tile) {
    const Eigen::VectorXd lengths = target_lengths(tile);
    const std::vector<int> places = places_of(tile);
    Signature signature{surface_area(tile.mesh), lengths.sum(), {}};
    for (const Chain& chain : tile.chains) {
        double length = 0;
        for (int i = 0; i < chain.edge_count(); ++i) length += lengths[places[at(chain.vertices[at(i)])]];
        signature.chains.push_back(length);
    }
    return signature;
}

Tile mirror_image(Tile tile) {
    tile.mesh.positions.col(0) *= -1;
    tile.mesh.triangles.col(1).swap(tile.mesh.triangles.col(2));
    std::reverse(tile.boundary.begin(), tile.boundary.end());
    tile.grain.direction.x() *= -1;
    if (tile.curve_lengths.size() > 0) {
        // Edge i starts at boundary[i]; after reversal it belongs to the vertex where it ended.
        std::reverse(tile.curve_lengths.begin(), tile.curve_lengths.end());
        std::rotate(tile.curve_lengths.begin(), tile.curve_lengths.begin() + 1, tile.curve_lengths.end());
    }
    if (Eigen::VectorXd& edges = tile.compensation.edges; edges.size() > 0) {
        std::reverse(edges.begin(), edges.end());
        std::rotate(edges.begin(), edges.begin() + 1, edges.end());
    }
    if (tile.compensation.strain.rows() > 0) tile.compensation.strain.col(2) *= -1;
    tile.compensation.chains.resize(tile.compensation.any() ? tile.chains.size() : 0, 0);
    std::reverse(tile.compensation.chains.begin(), tile.compensation.chains.end());
    std::reverse(tile.chains.begin(), tile.chains.end());
    for (Chain& chain : tile.chains) std::reverse(chain.vertices.begin(), chain.vertices.end());
    return tile;
}

/// Points at equal fractions of a chain (3 x #).
Eigen::Matrix3Xd points_along(const Tile& tile, const Chain& chain) {
    const Eigen::VectorXd lengths = edge_lengths(tile.mesh.positions, chain.vertices);
    Eigen::Matrix3Xd points(3, points_a_chain);
    const double total = lengths.sum();
    Eigen::Index edge = 0;
    double before = 0;
    for (int i = 0; i < points_a_chain; ++i) {
        const double s = total * i / points_a_chain;
        while (edge + 1 < lengths.size() && before + lengths[edge] < s) before += lengths[edge++];
        const Vec3 a = tile.mesh.positions.row(chain.vertices[at(edge)]);
        const Vec3 b = tile.mesh.positions.row(chain.vertices[static_cast<std::size_t>(edge) + 1]);
        points.col(i) = a + std::clamp((s - before) / lengths[edge], 0.0, 1.0) * (b - a);
    }
    return points;
}

Eigen::Matrix3Xd outline_points(const Tile& tile, std::size_t first_chain) {
    const std::size_t n = tile.chains.size();
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(n) * points_a_chain);
    for (std::size_t c = 0; c < n; ++c)
        points.middleCols(static_cast<Eigen::Index>(c) * points_a_chain, points_a_chain) =
            points_along(tile, tile.chains[(first_chain + c) % n]);
    return points;
}

/// A frame of the whole tile: centroid, mean normal and warp.
Eigen::Isometry3d frame_of(const Tile& tile, double sign) {
    const Vec3 normal = area_vector(tile.mesh).normalized();
    const Vec3& warp = tile.grain.direction;
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear().col(0) = sign * (warp - warp.dot(normal) * normal).normalized();
    frame.linear().col(2) = normal;
    frame.linear().col(1) = normal.cross(frame.linear().col(0));
    frame.translation() = centroid(tile.mesh);
    return frame;
}

/// A rigid motion that may map `one` to `other`, with the first chain of `one` on this chain of `other`.
struct Pose {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    std::size_t chain = 0;
};

std::vector<Pose> poses(const Tile& one, const Signature& first, const Tile& other, const Signature& second,
                        double tolerance) {
    std::vector<Pose> found;
    const std::size_t n = one.chains.size();
    if (n == 1)  // the tile may have no corner, so that its chain starts anywhere
        for (const double sign : {1.0, -1.0}) found.push_back({frame_of(other, sign) * frame_of(one, 1).inverse(), 0});
    const Eigen::Matrix3Xd from = outline_points(one, 0);
    for (std::size_t shift = 0; shift < n; ++shift) {
        bool fits = true;
        for (std::size_t c = 0; c < n && fits; ++c)
            fits = std::abs(first.chains[c] - second.chains[(c + shift) % n]) <= tolerance;
        if (!fits) continue;
        Pose pose;
        const Eigen::Matrix3Xd to = outline_points(other, shift);
        pose.motion.matrix() = Eigen::umeyama(from, to, false);
        pose.chain = shift;
        // A coarse test: sample points on different chords of one curve may be farther apart than vertices or
        // surfaces.
        const double apart = ((pose.motion * from) - to).colwise().norm().maxCoeff();
        if (apart <= 10 * tolerance + 0.01 * bounding_diagonal(one.mesh)) found.push_back(pose);
    }
    return found;
}

/// Traverses both meshes in parallel from one boundary edge each. Returns the vertex of `one` for each vertex of
/// `other`, or nothing if the meshes are not isomorphic.
std::vector<int> correspondence(const Tile& one, const Tile& other, int from_one, int from_other) {
    if (one.mesh.vertex_count() != other.mesh.vertex_count() ||
        one.mesh.triangle_count() != other.mesh.triangle_count() || one.boundary.size() != other.boundary.size())
        return {};
    const Adjacency first(one.mesh.triangles, one.mesh.vertex_count());
    const Adjacency second(other.mesh.triangles, other.mesh.vertex_count());
    const auto leaving = [](const Adjacency& adjacency, int vertex) {
        for (const int h : adjacency.outgoing(vertex))
            if (adjacency.is_boundary(h)) return h;
        return -1;
    };
    std::vector<int> partner(static_cast<std::size_t>(second.half_edge_count()), -1);
    std::vector<int> vertex(static_cast<std::size_t>(other.mesh.vertex_count()), -1);
    std::vector<std::array<int, 2>> open{{leaving(first, from_one), leaving(second, from_other)}};
    while (!open.empty()) {
        const auto [h, g] = open.back();
        open.pop_back();
        if (h < 0 || g < 0) {
            if (h != g) return {};
            continue;
        }
        if (partner[at(g)] >= 0) {
            if (partner[at(g)] != h) return {};
            continue;
        }
        partner[at(g)] = h;
        int& mate = vertex[at(second.from(g))];
        if (mate >= 0 && mate != first.from(h)) return {};
        mate = first.from(h);
        open.push_back({Adjacency::next(h), Adjacency::next(g)});
        open.push_back({first.twin(h), second.twin(g)});
    }
    return vertex;
}

/// Whether the corners and edge lengths of two isomorphic meshes agree too.
bool edges_agree(const Tile& one, const Tile& other, const std::vector<int>& vertex) {
    const Eigen::VectorXd first = target_lengths(one), second = target_lengths(other);
    const std::vector<int> places = places_of(one);
    for (std::size_t i = 0; i < other.boundary.size(); ++i) {
        const int place = places[at(vertex[at(other.boundary[i])])];
        if (place < 0 || std::abs(first[place] - second[static_cast<Eigen::Index>(i)]) > same_place) return false;
    }
    const auto corners = [](const Tile& tile, const std::vector<int>* through) {
        std::vector<int> list;
        for (const Chain& chain : tile.chains) {
            const int v = chain.vertices.front();
            list.push_back(through ? (*through)[at(v)] : v);
        }
        std::sort(list.begin(), list.end());
        return list;
    };
    return one.chains.size() == 1 || corners(one, nullptr) == corners(other, &vertex);
}

/// Whether the target strains of all triangles agree to rounding.
bool strains_agree(const Tile& one, const Tile& other, const std::vector<int>& vertex) {
    const Points3 &first = one.compensation.strain, &second = other.compensation.strain;
    if (first.rows() == 0 && second.rows() == 0) return true;
    if (first.rows() != second.rows() || vertex.empty()) return false;
    const auto sorted = [](std::array<int, 3> corners) {
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    std::map<std::array<int, 3>, int> triangle;
    for (int t = 0; t < one.mesh.triangle_count(); ++t)
        triangle[sorted({one.mesh.triangles(t, 0), one.mesh.triangles(t, 1), one.mesh.triangles(t, 2)})] = t;
    for (int t = 0; t < other.mesh.triangle_count(); ++t) {
        const auto at = [&](int k) { return vertex[static_cast<std::size_t>(other.mesh.triangles(t, k))]; };
        const auto found = triangle.find(sorted({at(0), at(1), at(2)}));
        if (found == triangle.end()) return false;
        if ((first.row(found->second) - second.row(t)).cwiseAbs().maxCoeff() > same_strain) return false;
    }
    return true;
}

double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const auto inside = [&](const Vec3& u, const Vec3& v) { return normal.dot((v - u).cross(p - u)) >= 0; };
    if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(normal.normalized().dot(p - a));
    const auto to_edge = [&](const Vec3& u, const Vec3& v) {
        const double along = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
        return (p - u - along * (v - u)).norm();
    };
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
}

/// Whether every point lies within `tolerance` of the mesh.
bool lies_on(const Eigen::Matrix3Xd& points, const TriangleMesh& mesh, double tolerance) {
    Eigen::Matrix3Xd lower(3, mesh.triangle_count()), upper(3, mesh.triangle_count());
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        lower.col(t) = mesh.corner(t, 0).cwiseMin(mesh.corner(t, 1)).cwiseMin(mesh.corner(t, 2));
        upper.col(t) = mesh.corner(t, 0).cwiseMax(mesh.corner(t, 1)).cwiseMax(mesh.corner(t, 2));
    }
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vec3 p = points.col(i);
        bool near = false;
        for (int t = 0; t < mesh.triangle_count() && !near; ++t)
            near = (p.array() >= lower.col(t).array() - tolerance).all() &&
                   (p.array() <= upper.col(t).array() + tolerance).all() &&
                   distance_to_triangle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)) <= tolerance;
        if (!near) return false;
    }
    return true;
}

/// The degree to which two tiles match in one pose, in increasing order.
enum class Alike { no, in_surface, in_vertices, exactly };

std::pair<Alike, Likeness> likeness_at(const Tile& one, const Tile& other, const Pose& pose, double tolerance) {
    Likeness found;
    found.motion = pose.motion;
    const Vec3 warp = pose.motion.linear() * one.grain.direction;
    found.grain_reversed = warp.dot(other.grain.direction) < 0;
    const double skew = (warp - (found.grain_reversed ? -1 : 1) * other.grain.direction).norm();
    // Warps given per triangle are not compared: such tiles are each of their own kind.
    const bool plain = one.grain.field.rows() == 0 && other.grain.field.rows() == 0;
    if (!plain || skew * bounding_diagonal(one.mesh) > tolerance) return {Alike::no, found};
    const Eigen::Matrix3Xd moved = pose.motion * one.mesh.positions.transpose();
    const Eigen::Matrix3Xd there = other.mesh.positions.transpose();
    const int start = one.chains.front().vertices.front();
    int mate = other.chains[pose.chain].vertices.front();
    if (one.chains.size() == 1)
        for (const int v : other.boundary)
            if ((there.col(v) - moved.col(start)).norm() < (there.col(mate) - moved.col(start)).norm()) mate = v;
    found.vertex = correspondence(one, other, start, mate);
    double apart = 0;
    for (std::size_t v = 0; v < found.vertex.size(); ++v)
        apart = std::max(apart, (moved.col(found.vertex[v]) - there.col(static_cast<Eigen::Index>(v))).norm());
    const bool exact =
        !found.vertex.empty() && apart <= same_place && skew <= same_place && edges_agree(one, other, found.vertex);
    if (!strains_agree(one, other, found.vertex)) return {Alike::no, found};
    if (exact) return {Alike::exactly, found};
    const bool vertices_agree = !found.vertex.empty() && apart <= tolerance;
    found.vertex.clear();
    if (vertices_agree) return {Alike::in_vertices, found};
    const bool lie_on_each_other =
        lies_on(moved, other.mesh, tolerance) && lies_on(pose.motion.inverse() * there, one.mesh, tolerance);
    return {lie_on_each_other ? Alike::in_surface : Alike::no, found};
}

/// The likeness of `other` to `one`, if there is one. A tile with two-fold rotational symmetry fits the other in two
/// poses. The one that also matches the vertices wins, because only then the flat pieces are the same.
std::optional<Likeness> compare(const Tile& one, const Tile& other, double tolerance) {
    if (one.fabric != other.fabric || one.compensation.warp != other.compensation.warp ||
        one.compensation.weft != other.compensation.weft)
        return std::nullopt;
    std::pair<Alike, Likeness> best{Alike::no, {}};
    for (const Pose& pose : poses(one, signature_of(one), other, signature_of(other), tolerance)) {
        std::pair<Alike, Likeness> found = likeness_at(one, other, pose, tolerance);
        if (found.first > best.first) best = std::move(found);
        if (best.first == Alike::exactly) break;
    }
    return best.first == Alike::no ? std::nullopt : std::optional(std::move(best.second));
}

bool may_be_equal(const Signature& a, const Signature& b, double tolerance) {
    if (a.chains.size() != b.chains.size() || std::abs(a.area - b.area) > tolerance * (a.perimeter + b.perimeter))
        return false;
    std::vector<double> first = a.chains, second = b.chains;
    std::sort(first.begin(), first.end());
    std::sort(second.begin(), second.end());
    return std::equal(first.begin(), first.end(), second.begin(),
                      [&](double x, double y) { return std::abs(x - y) <= tolerance; });
}

}  // namespace

std::vector<Likeness> find_equal_tiles(const std::vector<Tile>& tiles, double tolerance) {
    std::vector<Likeness> result(tiles.size());
    std::vector<Signature> signatures;
    for (const Tile& tile : tiles) signatures.push_back(signature_of(tile));
    std::multimap<double, int> firsts;  // sorted by perimeter
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const double room = tolerance * static_cast<double>(tiles[i].chains.size());
        std::vector<int> candidates;
        for (auto it = firsts.lower_bound(signatures[i].perimeter - room);
             it != firsts.end() && it->first <= signatures[i].perimeter + room; ++it)
            if (may_be_equal(signatures[at(it->second)], signatures[i], tolerance)) candidates.push_back(it->second);
        std::sort(candidates.begin(), candidates.end());
        std::optional<Likeness> found;
        for (const bool mirrored : {false, true})
            for (std::size_t c = 0; c < candidates.size() && !found; ++c) {
                const Tile& earlier = tiles[at(candidates[c])];
                found = compare(mirrored ? mirror_image(earlier) : earlier, tiles[i], tolerance);
                if (!found) continue;
                found->to = candidates[c];
                found->mirrored = mirrored;
            }
        if (found)
            result[i] = *found;
        else
            firsts.emplace(signatures[i].perimeter, static_cast<int>(i));
    }
    return result;
}

}  // namespace ripstop
