/// Seams from geometry alone: all are found, no others, and both sides are measured on one curve.
#include "ripstop/assembly/seams/find_seams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "ripstop/base/error.h"
#include "support/envelopes.h"
#include "support/shapes.h"

namespace ripstop {
namespace find_seams_test {

using std::numbers::pi;

double sum(const SeamSide& side) {
    return std::accumulate(side.parts.begin(), side.parts.end(), 0.0,
                           [](double total, const SeamPart& part) { return total + part.length; });
}

void expect_one_curve(const FoundSeams& found) {
    for (const Seam& seam : found.seams) {
        // Both sums are over the same stations, so only the rounding of the additions differs.
        EXPECT_NEAR(sum(seam.a), seam.length, 1e-12 * seam.length) << seam.id;
        EXPECT_NEAR(sum(seam.b), seam.length, 1e-12 * seam.length) << seam.id;
    }
}

/// A rectangle in the plane from (x0, y0) to (x1, y1).
NamedMesh sheet(const std::string& name, double x0, double y0, double x1, double y1, int nu, int nv) {
    return {name,
            testing::grid(nu, nv, [&](double u, double v) { return Vec3(x0 + (x1 - x0) * u, y0 + (y1 - y0) * v, 0); }),
            {}};
}

FoundSeams seams_of(const std::vector<NamedMesh>& meshes) {
    return find_seams(testing::tiles_of(meshes).tiles);
}

TEST(DesignedEnvelope, HasEverySeamFoundAndNoneInvented) {
    for (const double bulge : {0.0, 30 * degree}) {
        EnvelopeDesign design;
        design.edge_length = 0.3;
        design.bulge = bulge;
        const Envelope envelope = testing::tiles_of(design_natural(design));
        const FoundSeams found = find_seams(envelope.tiles);
        EXPECT_EQ(static_cast<int>(found.seams.size()), testing::seam_count(design));
        EXPECT_TRUE(found.near_misses.empty());
        EXPECT_TRUE(found.same_way.empty());
        expect_one_curve(found);
    }
}

TEST(DesignedEnvelope, KeepsItsEdgeLengthsBitForBitWhereItsMeshesConform) {
    const Envelope envelope = testing::tiles_of(design_natural({.edge_length = 0.3}));
    for (const Eigen::VectorXd& lengths : find_seams(envelope.tiles).curve_lengths) EXPECT_EQ(lengths.size(), 0);
}

TEST(TilesMeshedApart, HaveEverySeamFoundAndNoneInvented) {
    for (const unsigned seed : {1u, 2u, 3u})
        for (const double bulge : {0.0, 30 * degree}) {
            EnvelopeDesign design;
            design.bulge = bulge;
            const FoundSeams found = seams_of(testing::meshed_apart(design, seed, bulge > 0 ? 2 : 1));
            EXPECT_EQ(static_cast<int>(found.seams.size()), testing::seam_count(design)) << seed;
            EXPECT_TRUE(found.near_misses.empty());
            expect_one_curve(found);
        }
}

TEST(BrickWall, HasASeamForEachHalfOfALongEdge) {
    const int rows = 6, bricks = 12;
    const Envelope envelope = testing::tiles_of(testing::brick_wall(rows, bricks));
    const FoundSeams found = find_seams(envelope.tiles);
    EXPECT_EQ(static_cast<int>(found.seams.size()), rows * bricks + (rows - 1) * 2 * bricks);
    EXPECT_TRUE(found.near_misses.empty());
    expect_one_curve(found);
    for (const Seam& seam : found.seams) {
        EXPECT_LT(seam.gap, 1e-9) << "arcs of circles: both curves are true to sixth order";
    }
}

/// A cone with this half angle and a slant height of 1 m, cut open along +x: a disk whose boundary runs up the cut
/// to the apex and down again. `bent` moves the vertices of one side along the cut.
NamedMesh cut_cone(double half, int around, int rings, double bent) {
    TriangleMesh mesh;
    mesh.positions.resize(1 + rings * (around + 1), 3);
    mesh.positions.row(0).setZero();
    for (int r = 1; r <= rings; ++r)
        for (int i = 0; i <= around; ++i) {
            double s = double(r) / rings;
            if (i == around) s += bent * s * (1 - s);
            const double phi = i == around ? 0 : 2 * pi * i / around;
            mesh.positions.row(1 + (r - 1) * (around + 1) + i) =
                s * Vec3(std::sin(half) * std::cos(phi), std::sin(half) * std::sin(phi), -std::cos(half)).transpose();
        }
    mesh.triangles.resize(around * (2 * rings - 1), 3);
    int t = 0;
    for (int i = 0; i < around; ++i) mesh.triangles.row(t++) << 0, 1 + i, 2 + i;
    for (int r = 1; r < rings; ++r)
        for (int i = 0; i < around; ++i) {
            const int a = 1 + (r - 1) * (around + 1) + i, b = a + around + 1;
            mesh.triangles.row(t++) << a, b, b + 1;
            mesh.triangles.row(t++) << a, b + 1, a + 1;
        }
    return {"cone", mesh, {}};
}

TEST(ConeCutOpen, IsSewnToItselfUpToTheApexWhetherThatIsACornerOrNot) {
    // at sin 30 degrees the cone unrolls to a half disk, whose middle is no corner; at 60 the apex is the tip of a
    // dart
    for (const double half : {30 * degree, 60 * degree})
        for (const double bent : {0.0, 0.4}) {
            const Envelope envelope = testing::tiles_of({cut_cone(half, 24, 8, bent)});
            EXPECT_EQ(envelope.tiles[0].chains.size(), half < 1 ? 2u : 3u);
            const FoundSeams found = find_seams(envelope.tiles);
            ASSERT_EQ(found.seams.size(), 1u) << half << " " << bent;
            const Seam& seam = found.seams[0];
            EXPECT_NEAR(seam.length, 1, 1e-12) << "a straight cut: its curve is itself";
            EXPECT_EQ(seam.a.parts.size(), 8u);
            EXPECT_EQ(seam.b.parts.size(), 8u);
            EXPECT_EQ(seam.a.tile, seam.b.tile);
            EXPECT_EQ(seam.a.chain == seam.b.chain, half < 1);
            expect_one_curve(found);
        }
}

TEST(EdgesThatCross, AreNotSewnButReported) {
    // the edges are within half a millimetre over 50 mm about the crossing, 0.4 m from the tip of the wedge
    const NamedMesh low = sheet("low", 0, -1, 2, 0, 5, 7);
    for (const double start : {-0.01, 0.0}) {
        NamedMesh high = sheet("high", 0, 0, 2, 1, 40, 4);
        for (Eigen::Index v = 0; v < high.mesh.positions.rows(); ++v)
            high.mesh.positions(v, 1) += start + (start < 0 ? 0.01 : 0.001) * high.mesh.positions(v, 0);
        const FoundSeams found = seams_of({low, high});
        EXPECT_TRUE(found.seams.empty()) << start;
        EXPECT_EQ(found.near_misses.size(), 1u) << start;
    }
}

TEST(TilesThatTouchAtACorner, AreNotSewn) {
    const FoundSeams found = seams_of({sheet("left", 0, 0, 1, 1, 5, 5), sheet("right", 1, 1, 2, 2, 7, 7)});
    EXPECT_TRUE(found.seams.empty());
    EXPECT_TRUE(found.near_misses.empty());
}

TEST(FourTilesAtACorner, HaveFourSeams) {
    const FoundSeams found = seams_of({sheet("a", 0, 0, 1, 1, 5, 5), sheet("b", 1, 0, 2, 1, 6, 4),
                                       sheet("c", 0, 1, 1, 2, 3, 7), sheet("d", 1, 1, 2, 2, 8, 8)});
    EXPECT_EQ(found.seams.size(), 4u);
    EXPECT_TRUE(found.near_misses.empty());
    for (const Seam& seam : found.seams) EXPECT_NEAR(seam.length, 1, 1e-12);
}

TEST(TJunction, LiesAnywhereInAnEdge) {
    // the long edge has a vertex every quarter of a metre; the short ones meet at 0.9 m
    const Envelope envelope = testing::tiles_of(
        {sheet("long", 0, 0, 2, 1, 8, 4), sheet("first", 0, 1, 0.9, 2, 5, 4), sheet("second", 0.9, 1, 2, 2, 7, 4)});
    const FoundSeams found = find_seams(envelope.tiles);
    ASSERT_EQ(found.seams.size(), 3u);
    expect_one_curve(found);
    std::vector<int> shared;
    for (const Seam& seam : found.seams)
        if (seam.a.tile == 0)
            for (const SeamPart& part : seam.a.parts) shared.push_back(part.edge);
    EXPECT_EQ(shared.size(), 9u) << "eight edges, one of them in two seams";
    std::sort(shared.begin(), shared.end());
    EXPECT_EQ(std::unique(shared.begin(), shared.end()) - shared.begin(), 8);
    if (found.curve_lengths[0].size() > 0) {
        EXPECT_NEAR(found.curve_lengths[0].sum(), 6, 1e-12);
    }
}

TEST(OpenEdges, AreInNoSeam) {
    const FoundSeams found = seams_of({sheet("left", 0, 0, 1, 1, 5, 5), sheet("right", 1, 0.25, 2, 2, 7, 6)});
    ASSERT_EQ(found.seams.size(), 1u);
    // from the right sheet's corner to the left one's last vertex beside it, which is its corner
    EXPECT_NEAR(found.seams[0].length, 0.75, 1e-12);
}

TEST(Loops, AreSewnToOtherLoopsAndToManyTilesAlike) {
    // a cap on a ring of strips, whose seams do not begin where the cap's boundary begins
    const double theta = 0.6;
    std::vector<NamedMesh> meshes{{"cap", testing::cap(theta, 9), {}}};
    for (int i = 0; i < 5; ++i)
        meshes.push_back({"strip" + std::to_string(i),
                          testing::grid(11, 4,
                                        [&](double u, double v) {
                                            const double t = 1.0 + (theta - 1.0) * v, p = 2 * pi * (i + 0.37 + u) / 5;
                                            return Vec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p),
                                                        std::cos(t));
                                        }),
                          {}});
    const Envelope envelope = testing::tiles_of(meshes);
    ASSERT_EQ(envelope.tiles[0].chains.size(), 1u);
    const FoundSeams found = find_seams(envelope.tiles);
    EXPECT_EQ(found.seams.size(), 10u);
    EXPECT_TRUE(found.near_misses.empty());
    expect_one_curve(found);
    const double round = 2 * pi * std::sin(theta);
    EXPECT_NEAR(found.curve_lengths[0].sum(), round, 1e-4 * round);
}

/// Two strips along an arc of a circle: one has `inside` edges on it, the other `outside`.
std::vector<NamedMesh> strips_on_arc(double radius, double angle, int inside, int outside) {
    const auto strip = [&](double r0, double r1, int edges) {
        return testing::grid(edges, 3, [=](double u, double v) {
            const double r = r0 + (r1 - r0) * v, phi = angle * u;
            return Vec3(r * std::cos(phi), r * std::sin(phi), 0);
        });
    };
    NamedMesh inner{"inner", strip(radius, 0.8 * radius, inside), {}};
    NamedMesh outer{"outer", strip(1.2 * radius, radius, outside), {}};
    return {inner, outer};
}

TEST(UncertaintyOfASeam, CoversTheTrueErrorOnArcs) {
    for (const double degrees : {20.0, 60.0, 90.0})
        for (const auto& [inside, outside] :
             std::vector<std::pair<int, int>>{{4, 4}, {9, 9}, {4, 5}, {5, 7}, {6, 19}, {20, 20}, {23, 40}}) {
            const double radius = 5, truth = radius * degrees * degree;
            const FoundSeams found = seams_of(strips_on_arc(radius, degrees * degree, inside, outside));
            ASSERT_EQ(found.seams.size(), 1u) << degrees << " " << inside << " " << outside;
            const Seam& seam = found.seams[0];
            const double error = std::abs(seam.length - truth);
            EXPECT_LE(error, seam.uncertainty + 1e-13) << degrees << " " << inside << " " << outside;
            // the bound is also tight: at most twice the error of the coarser polyline
            const double turn = degrees * degree / std::min(inside, outside);
            EXPECT_LE(seam.uncertainty, 2 * truth * turn * turn / 24 + 1e-13);
        }
}

/// Two strips along a curve (t from 0 to 1), one on each side.
std::vector<NamedMesh> strips_on_curve(const std::function<Vec3(double)>& curve, int upper, int lower) {
    const auto strip = [&](int edges, double top, double bottom) {
        return testing::grid(edges, 3, [&, top, bottom](double u, double v) {
            return Vec3(curve(u) + Vec3(0, 0, top + (bottom - top) * v));
        });
    };
    NamedMesh above{"above", strip(upper, 0.5, 0), {}}, below{"below", strip(lower, 0, -0.5), {}};
    return {above, below};
}

TEST(CommonCurve, ConvergesToFourthOrderAndItsUncertaintyCoversTheError) {
    const std::function<Vec3(double)> ellipse = [](double t) {
        return Vec3(4 * std::cos(t * pi / 2), 1.5 * std::sin(t * pi / 2), 0);
    };
    const std::function<Vec3(double)> wave = [](double t) {
        return Vec3(3 * t, 0.3 * std::sin(6 * t), 0.2 * std::cos(4 * t));
    };
    for (const auto& curve : {ellipse, wave}) {
        double truth = 0;  // by a polyline so fine that its relative error is 1e-11
        for (int i = 0; i < 200000; ++i) truth += (curve((i + 1) / 2e5) - curve(i / 2e5)).norm();
        for (const int edges : {12, 24, 48}) {
            const std::vector<NamedMesh> strips = strips_on_curve(curve, edges, edges * 3 / 2 - 1);
            const FoundSeams found = find_seams(testing::tiles_of(strips).tiles, {0.002});
            ASSERT_EQ(found.seams.size(), 1u) << edges;
            const double error = std::abs(found.seams[0].length - truth);
            EXPECT_LE(error, found.seams[0].uncertainty) << edges;
            EXPECT_LT(error, 1e-5 * std::pow(12.0 / edges, 3.5) * truth) << edges;

            const Envelope same = testing::tiles_of(strips_on_curve(curve, edges, edges));
            const Seam conforming = find_seams(same.tiles, {0.002}).seams.at(0);
            EXPECT_LE(std::abs(conforming.length - truth), conforming.uncertainty) << edges << " conforming";
        }
    }
}

TEST(Seams, DoNotDependOnTheOrderOrThePoseOfTheTiles) {
    std::vector<NamedMesh> meshes = testing::meshed_apart({.gores = 8, .panels = 5}, 5);
    const auto lengths = [](const std::vector<NamedMesh>& tiles) {
        const Envelope envelope = testing::tiles_of(tiles);
        std::vector<std::tuple<std::string, std::string, double>> seams;
        for (const Seam& seam : find_seams(envelope.tiles).seams) {
            std::string a = envelope.tiles[static_cast<std::size_t>(seam.a.tile)].name;
            std::string b = envelope.tiles[static_cast<std::size_t>(seam.b.tile)].name;
            if (b < a) std::swap(a, b);
            seams.emplace_back(a, b, seam.length);
        }
        std::sort(seams.begin(), seams.end());
        return seams;
    };
    const auto expected = lengths(meshes);
    EXPECT_EQ(expected.size(), 8u * 5 + 8 * 4);
    std::reverse(meshes.begin(), meshes.end());
    std::rotate(meshes.begin(), meshes.begin() + 7, meshes.end());
    for (NamedMesh& mesh : meshes) mesh.mesh = testing::moved(testing::shuffled(mesh.mesh, 3));
    const auto other = lengths(meshes);
    ASSERT_EQ(other.size(), expected.size());
    for (std::size_t i = 0; i < other.size(); ++i) {
        EXPECT_EQ(std::get<0>(other[i]), std::get<0>(expected[i]));
        EXPECT_EQ(std::get<1>(other[i]), std::get<1>(expected[i]));
        // rounding of the moved coordinates
        EXPECT_NEAR(std::get<2>(other[i]), std::get<2>(expected[i]), 1e-9);
    }
}

TEST(SeamTolerance, MustBeSmallAgainstTheEdges) {
    std::vector<NamedMesh> meshes = testing::meshed_apart({.gores = 8, .panels = 5}, 5);
    for (NamedMesh& mesh : meshes) mesh.mesh.positions *= 0.001;
    Envelope envelope = testing::tiles_of(meshes);
    EXPECT_THROW(find_seams(envelope.tiles), InputError);
    add_seams(envelope);
    EXPECT_TRUE(envelope.seams.empty());
    EXPECT_EQ(find_seams(envelope.tiles, {0.5e-6}).seams.size(), 8u * 5 + 8 * 4);
}

TEST(SeamTolerance, MustBeALength) {
    for (const double tolerance : {0.0, -1.0, std::nan("")})
        EXPECT_THROW(find_seams({}, {tolerance}), InputError) << tolerance;
}

}  // namespace find_seams_test
}  // namespace ripstop
