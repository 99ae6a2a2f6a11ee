#include "ripstop/measure/equal_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/base/text/units.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/shapes.h"

namespace ripstop {
namespace equal_tiles_test {

/// A patch without any symmetry.
TriangleMesh odd_patch(int nu = 6, int nv = 8) {
    return testing::grid(nu, nv, [](double u, double v) {
        const double x = u * (1 + 0.3 * v), y = 1.5 * v;
        return Vec3(x, y, 0.2 * x * x - 0.1 * x * y);
    });
}

const Eigen::Isometry3d motion = Eigen::Translation3d(3, -2, 5) * Eigen::AngleAxisd(2.1, Vec3(1, 2, -0.5).normalized());

TriangleMesh moved(TriangleMesh mesh) {
    mesh.positions = (motion * mesh.positions.transpose()).transpose();
    return mesh;
}

Tile tile(const TriangleMesh& mesh, const Vec3& warp, const TileOptions& options = {}) {
    TileOptions all = options;
    all.warp = warp;
    return make_tile("t", mesh, all);
}

Vec3 moved_warp(const Vec3& warp) {
    return motion.linear() * warp;
}

const Vec3 warp = Vec3(1, 0.3, 0).normalized();

/// The largest distance of the vertices of `other` from where the likeness maps them.
double largest_distance(const Tile& one, const Tile& other, const Likeness& likeness) {
    double largest = 0;
    for (std::size_t v = 0; v < likeness.vertex.size(); ++v) {
        Vec3 from = one.mesh.positions.row(likeness.vertex[v]);
        if (likeness.mirrored) from.x() *= -1;
        largest = std::max(
            largest, (likeness.motion * from - Vec3(other.mesh.positions.row(static_cast<Eigen::Index>(v)))).norm());
    }
    return largest;
}

TEST(EqualTiles, AreMatchedVertexByVertexWhereATileIsItsOwnImageByHalfATurn) {
    // A gore whose diagonals all point one way also matches itself turned end for end, with different triangles.
    TriangleMesh gore = testing::lune(22.5 * degree, 4, 24);
    for (const double rounding : {0.0, 1e-9})
        for (unsigned order = 1; order <= 8; ++order) {
            TriangleMesh other = testing::shuffled(moved(gore), order);
            if (rounding > 0) other.positions = (other.positions / rounding).array().round() * rounding;
            const std::vector<Tile> tiles{tile(gore, Vec3::UnitZ()), tile(other, moved_warp(Vec3::UnitZ()))};
            const Likeness found = find_equal_tiles(tiles)[1];
            ASSERT_EQ(found.to, 0) << order;
            EXPECT_FALSE(found.grain_reversed) << order << ": the two lie on each other as they were made";
        }
}

TEST(EqualTiles, AreFoundInAnyPoseAndNumbering) {
    std::vector<int> order;
    const TriangleMesh shuffled = testing::shuffled(moved(odd_patch()), 7, &order);
    const std::vector<Tile> tiles{tile(odd_patch(), warp), tile(shuffled, moved_warp(warp))};
    const std::vector<Likeness> found = find_equal_tiles(tiles);
    EXPECT_EQ(found[0].to, -1);
    ASSERT_EQ(found[1].to, 0);
    EXPECT_FALSE(found[1].mirrored);
    EXPECT_FALSE(found[1].grain_reversed);
    EXPECT_EQ(found[1].vertex, order);
    EXPECT_LT(largest_distance(tiles[0], tiles[1], found[1]), 1e-12);
}

TEST(EqualTiles, RightsAndLeftsAreMirrorImages) {
    const Vec3 other_warp(-warp.x(), warp.y(), warp.z());
    const std::vector<Tile> tiles{
        tile(odd_patch(), warp),
        tile(testing::shuffled(moved(testing::mirrored(odd_patch())), 3), moved_warp(other_warp))};
    const Likeness found = find_equal_tiles(tiles)[1];
    ASSERT_EQ(found.to, 0);
    EXPECT_TRUE(found.mirrored);
    ASSERT_FALSE(found.vertex.empty());
    EXPECT_LT(largest_distance(tiles[0], tiles[1], found), 1e-12);
}

TEST(EqualTiles, AWarpThatPointsTheOtherWayIsTheSameCloth) {
    const Likeness found = find_equal_tiles({tile(odd_patch(), warp), tile(moved(odd_patch()), -moved_warp(warp))})[1];
    EXPECT_EQ(found.to, 0);
    EXPECT_TRUE(found.grain_reversed);
}

TEST(EqualTiles, DifferInWarpCompensationAndEdgeLengths) {
    const Tile first = tile(odd_patch(), warp);
    EXPECT_EQ(find_equal_tiles({first, tile(odd_patch(), Vec3::UnitY())})[1].to, -1);
    EXPECT_EQ(find_equal_tiles({first, tile(odd_patch(), Vec3(1, 0.305, 0))})[1].to, -1);
    EXPECT_EQ(find_equal_tiles({first, tile(odd_patch(), warp, {.compensation = {.warp = 0.01}})})[1].to, -1);
    EXPECT_EQ(find_equal_tiles({first, tile(odd_patch(), warp, {.compensation = {.chains = {0.001}}})})[1].to, -1);
    Tile longer = first;
    longer.curve_lengths = drawn_lengths(first);
    EXPECT_EQ(find_equal_tiles({first, longer})[1].to, 0);
    longer.curve_lengths[2] += 0.001;
    EXPECT_EQ(find_equal_tiles({first, longer})[1].to, -1);
}

TEST(EqualTiles, CompensationOfEdgesIsMirroredWithThem) {
    const Vec3 other_warp(-warp.x(), warp.y(), warp.z());
    const TriangleMesh mirrored = testing::mirrored(odd_patch());
    const Tile plain = tile(mirrored, other_warp);
    // The right edge of one tile is the left edge of the other, whatever their numbers as chains.
    const auto chain_at = [](const Tile& of, double x) {
        for (std::size_t c = 0; c < of.chains.size(); ++c) {
            const std::vector<int>& v = of.chains[c].vertices;
            const Vec3 middle = of.mesh.positions.row(v[v.size() / 2]);
            if (std::abs(middle.x() - x) < 1e-9) return c;
        }
        return of.chains.size();
    };
    const Tile first = tile(odd_patch(), warp);
    std::vector<double> extra(4, 0), other_extra(4, 0);
    extra[chain_at(first, 1.15)] = 0.002;
    other_extra[chain_at(plain, -1.15)] = 0.002;
    const Tile right = tile(odd_patch(), warp, {.compensation = {.chains = extra}});
    const Tile left = tile(mirrored, other_warp, {.compensation = {.chains = other_extra}});
    EXPECT_EQ(find_equal_tiles({right, left})[1].to, 0);
    EXPECT_EQ(find_equal_tiles({right, plain})[1].to, -1);
}

TEST(EqualTiles, MeansWithinATenthOfAMillimetre) {
    TriangleMesh near = moved(odd_patch()), far = near;
    near.positions.row(17) += 0.00009 * moved_warp(Vec3::UnitZ()).transpose();  // about along the normal
    far.positions.row(17) += 0.0002 * moved_warp(Vec3::UnitZ()).transpose();
    const auto found =
        find_equal_tiles({tile(odd_patch(), warp), tile(near, moved_warp(warp)), tile(far, moved_warp(warp))});
    EXPECT_EQ(found[1].to, 0);
    EXPECT_TRUE(found[1].vertex.empty()) << "too far off to be cut by a copy";
    EXPECT_EQ(found[2].to, -1);
}

TEST(EqualTiles, OneSurfaceMeshedInTwoWaysIsOneTile) {
    // Two bent sheets that are the same prism; one has more rows.
    const TriangleMesh coarse = testing::cylinder(1, 0.8, 1.3, 8, 3),
                       fine = moved(testing::cylinder(1, 0.8, 1.3, 8, 7));
    const auto found = find_equal_tiles({tile(coarse, Vec3::UnitZ()), tile(fine, moved_warp(Vec3::UnitZ()))});
    EXPECT_EQ(found[1].to, 0);
    EXPECT_TRUE(found[1].vertex.empty());
    EXPECT_EQ(find_equal_tiles({tile(coarse, Vec3::UnitZ()),
                                tile(moved(testing::cylinder(1, 0.8, 1.3, 5, 3)), moved_warp(Vec3::UnitZ()))})[1]
                  .to,
              -1)
        << "a prism of other facets is another surface";
}

TEST(EqualTiles, ATileWithoutCornersIsRecognisedTurnedAboutItself) {
    const TriangleMesh cap = testing::cap(0.4, 5);
    const auto found =
        find_equal_tiles({tile(cap, Vec3::UnitX()), tile(testing::shuffled(moved(cap), 5), moved_warp(Vec3::UnitX()))});
    EXPECT_EQ(found[1].to, 0);
    EXPECT_FALSE(found[1].vertex.empty());
}

TEST(EqualTiles, OfADesignedEnvelopeAreItsPanelsOncePerGore) {
    const Envelope envelope = make_envelope(design_natural({.gores = 12, .panels = 5, .edge_length = 0.6}), {});
    const std::vector<Likeness> found = find_equal_tiles(envelope.tiles);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i < 5) {
            EXPECT_EQ(found[i].to, -1) << i;
        } else {
            EXPECT_EQ(found[i].to, static_cast<int>(i % 5)) << i;
            EXPECT_FALSE(found[i].vertex.empty()) << i;
        }
    }
}

}  // namespace equal_tiles_test
}  // namespace ripstop
