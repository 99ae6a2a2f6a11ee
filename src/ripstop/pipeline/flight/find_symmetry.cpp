#include "ripstop/pipeline/flight/find_symmetry.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "ripstop/base/index.h"
#include "ripstop/measure/equal_tiles.h"

namespace ripstop {
namespace {

constexpr double same_symmetric_place = 1e-6;  // [m]
constexpr double same_cloth = 1e-9;            // difference of squared edge lengths [m2]

/// Where the vertical axis of a rotation meets the plane z = 0; empty if the motion is no rotation about a vertical
/// axis.
std::optional<Vec3> axis_of(const Eigen::Isometry3d& motion) {
    const Eigen::Matrix3d& R = motion.linear();
    if ((R * Vec3::UnitZ() - Vec3::UnitZ()).norm() > 1e-6 || std::abs(motion.translation().z()) > same_symmetric_place)
        return std::nullopt;
    const Mat22 A = Mat22::Identity() - R.topLeftCorner<2, 2>();
    if (std::abs(A.determinant()) < 1e-9) return std::nullopt;
    Vec3 axis = Vec3::Zero();
    axis.head<2>() = A.inverse() * motion.translation().head<2>();
    return axis;
}

/// Whether the flat triangles of two tiles are equal under the vertex map.
bool is_cut_alike(const FlatTile& one, const FlatTile& other, const std::vector<int>& vertex) {
    const Points2 &u = one.flattening.positions, &w = other.flattening.positions;
    if (u.rows() != w.rows()) return false;
    const Triangles& triangles = other.tile.mesh.triangles;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k) {
            const int a = triangles(t, k), b = triangles(t, (k + 1) % 3);
            const double there = (u.row(vertex[at(a)]) - u.row(vertex[at(b)])).squaredNorm();
            if (!(std::abs((w.row(a) - w.row(b)).squaredNorm() - there) <= same_cloth)) return false;
        }
    return true;
}

/// Whether every seam of a sector recurs in all others, with the same tape or without.
bool is_sewn_alike(const CutPlan& plan, const Symmetry& symmetry) {
    std::map<std::tuple<int, int, int, bool>, int> count;
    for (const Seam& seam : plan.seams) {
        TurnedTile a = symmetry.tiles[at(seam.a.tile)];
        TurnedTile b = symmetry.tiles[at(seam.b.tile)];
        int turns = (b.turns - a.turns + symmetry.sectors) % symmetry.sectors;
        const int back = (symmetry.sectors - turns) % symmetry.sectors;
        if (std::tie(b.of, back) < std::tie(a.of, turns)) {
            std::swap(a, b);
            turns = back;
        }
        ++count[{a.of, b.of, turns, seam.type.tape}];
    }
    return std::all_of(count.begin(), count.end(),
                       [&](const auto& each) { return each.second % symmetry.sectors == 0; });
}

Symmetry whole(const CutPlan& plan) {
    Symmetry symmetry;
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) symmetry.tiles.push_back({static_cast<int>(i), 0, {}});
    return symmetry;
}

/// The symmetry with this number of sectors about this axis; one sector if the tiles do not fit.
Symmetry with_sectors(const CutPlan& plan, const std::vector<Likeness>& likeness, int sectors, const Vec3& axis) {
    Symmetry symmetry = whole(plan);
    symmetry.sectors = sectors;
    symmetry.axis = axis;
    const double angle = symmetry.angle();
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        const Likeness& like = likeness[i];
        if (like.to < 0) continue;
        if (like.mirrored || like.vertex.empty()) return whole(plan);
        const double turn = std::atan2(like.motion.linear()(1, 0), like.motion.linear()(0, 0));
        const int turns = (static_cast<int>(std::lround(turn / angle)) % sectors + sectors) % sectors;
        const Eigen::Isometry3d motion =
            Eigen::Translation3d(axis) * Eigen::AngleAxisd(turns * angle, Vec3::UnitZ()) * Eigen::Translation3d(-axis);
        const auto& first = plan.tiles[at(like.to)];
        const Points3 &x = first.tile.mesh.positions, &there = plan.tiles[i].tile.mesh.positions;
        for (Eigen::Index v = 0; v < there.rows(); ++v)
            if ((motion * Vec3(x.row(like.vertex[at(v)])) - Vec3(there.row(v))).norm() > same_symmetric_place)
                return whole(plan);
        if (!is_cut_alike(first, plan.tiles[i], like.vertex)) return whole(plan);
        symmetry.tiles[i] = {like.to, turns, like.vertex};
    }
    return is_sewn_alike(plan, symmetry) ? symmetry : whole(plan);
}

}  // namespace

Symmetry find_symmetry(const CutPlan& plan) {
    std::vector<Tile> tiles;
    for (const FlatTile& tile : plan.tiles) tiles.push_back(tile.tile);
    const std::vector<Likeness> likeness = find_equal_tiles(tiles);
    std::map<int, int> sizes;
    std::optional<Vec3> axis;
    for (std::size_t i = 0; i < likeness.size(); ++i) {
        ++sizes[likeness[i].to < 0 ? static_cast<int>(i) : likeness[i].to];
        if (!axis && likeness[i].to >= 0) axis = axis_of(likeness[i].motion);
    }
    int sectors = 0;
    for (const auto& [first, size] : sizes) sectors = std::gcd(sectors, size);
    return sectors < 2 || !axis ? whole(plan) : with_sectors(plan, likeness, sectors, *axis);
}

}  // namespace ripstop
