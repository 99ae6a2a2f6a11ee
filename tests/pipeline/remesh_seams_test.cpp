#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/assembly/seams/find_seams.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/pipeline/remesh/remesh_envelope.h"
#include "ripstop/remesh/remesh_disk.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/envelopes.h"
#include "support/poor_meshes.h"
#include "support/remeshing.h"
#include "support/shapes.h"

namespace ripstop {
namespace remesh_seams_test {

using namespace testing;

using RemeshedSeams = RemeshingTest;

std::vector<double> chain_lengths(const Tile& tile) {
    const Eigen::VectorXd drawn = drawn_lengths(tile);
    std::vector<double> lengths;
    for (const Chain& chain : tile.chains) {
        double sum = 0;
        for (int e = 0; e < chain.edge_count(); ++e)
            sum += drawn[std::find(tile.boundary.begin(), tile.boundary.end(),
                                   chain.vertices[static_cast<std::size_t>(e)]) -
                         tile.boundary.begin()];
        lengths.push_back(sum);
    }
    return lengths;
}

/// The vertices of a side of a seam, in the order of side a.
std::vector<Vec3> vertices_of(const Envelope& envelope, const SeamSide& side, bool reversed) {
    const Tile& tile = envelope.tiles[static_cast<std::size_t>(side.tile)];
    std::vector<Vec3> points;
    for (const SeamPart& part : side.parts)
        points.push_back(tile.mesh.positions.row(tile.boundary[static_cast<std::size_t>(part.edge)]));
    const std::size_t last = static_cast<std::size_t>(side.parts.back().edge + 1) % tile.boundary.size();
    points.push_back(tile.mesh.positions.row(tile.boundary[last]));
    if (reversed) std::reverse(points.begin(), points.end());
    return points;
}

void expect_same_vertices(const Envelope& envelope, double corners) {
    for (const Seam& seam : envelope.seams) {
        const std::vector<Vec3> a = vertices_of(envelope, seam.a, false), b = vertices_of(envelope, seam.b, true);
        ASSERT_EQ(a.size(), b.size()) << seam.id;
        for (std::size_t k = 1; k + 1 < a.size(); ++k) EXPECT_EQ(a[k], b[k]) << seam.id;
        EXPECT_LT((a.front() - b.front()).norm(), corners) << seam.id;
        EXPECT_LT((a.back() - b.back()).norm(), corners) << seam.id;
        double length_a = 0, length_b = 0;
        for (const SeamPart& part : seam.a.parts) length_a += part.length;
        for (const SeamPart& part : seam.b.parts) length_b += part.length;
        EXPECT_NEAR(length_a, seam.length, 1e-9 * seam.length);
        EXPECT_NEAR(length_b, seam.length, 1e-9 * seam.length);
    }
}

EnvelopeDesign small_design() {
    EnvelopeDesign design;
    design.gores = 6;
    design.panels = 3;
    return design;
}

TEST_F(RemeshedSeams, GivesBothSidesOfEverySeamTheSameVerticesAndKeepsTheLengths) {
    Envelope envelope = make_envelope(meshed_apart(small_design(), 3, 6), {});
    const Envelope before = envelope;
    const std::vector<std::string> remarks = remesh_envelope(envelope, by_length(0.6));
    ASSERT_EQ(envelope.seams.size(), before.seams.size());
    for (const Tile& tile : envelope.tiles)
        EXPECT_TRUE(tile.remeshed) << tile.name << ": " << ::testing::PrintToString(remarks);
    expect_same_vertices(envelope, 1e-6);
    for (std::size_t s = 0; s < before.seams.size(); ++s) {
        EXPECT_EQ(envelope.seams[s].id, before.seams[s].id);
        EXPECT_NEAR(envelope.seams[s].length, before.seams[s].length, 1e-9 * before.seams[s].length);
    }
    for (std::size_t t = 0; t < before.tiles.size(); ++t) {
        EXPECT_EQ(corners_of(envelope.tiles[t]), corners_of(before.tiles[t]));
        EXPECT_LE(locked_edges(envelope.tiles[t].mesh), 0) << before.tiles[t].name;
    }
}

TEST_F(RemeshedSeams, FindsTheCornersInABrickWall) {
    Envelope envelope = make_envelope(brick_wall(3, 6), {});
    const Envelope before = envelope;
    remesh_envelope(envelope, by_length(0.05));
    for (const Tile& tile : envelope.tiles) EXPECT_TRUE(tile.remeshed) << tile.name;
    ASSERT_EQ(envelope.seams.size(), before.seams.size());
    expect_same_vertices(envelope, 0.5 * millimetre);
    for (std::size_t t = 0; t < before.tiles.size(); ++t) {
        const std::vector<double> was = chain_lengths(before.tiles[t]), is = chain_lengths(envelope.tiles[t]);
        for (std::size_t c = 0; c < was.size(); ++c)
            EXPECT_NEAR(is[c], was[c], 2 * millimetre) << before.tiles[t].name;  // smooth curve, not polyline
    }
}

TEST_F(RemeshedSeams, OfATileSewnToItselfKeepsItsSeam) {
    // A cone cut open along a ruling: both of its straight edges are one seam.
    const TriangleMesh mesh = grid(16, 4, [](double u, double v) {
        const double slant = 0.5 + 1.5 * v, turn = 2 * std::numbers::pi * u;
        return Vec3(slant * std::sin(0.4) * std::cos(turn), slant * std::sin(0.4) * std::sin(turn),
                    slant * std::cos(0.4));
    });
    Envelope envelope = make_envelope({{"cone", mesh}}, {});
    ASSERT_EQ(envelope.seams.size(), 1u);
    const double length = envelope.seams[0].length;
    remesh_envelope(envelope, automatic);
    ASSERT_TRUE(envelope.tiles[0].remeshed);
    ASSERT_EQ(envelope.seams.size(), 1u);
    EXPECT_NEAR(envelope.seams[0].length, length, 1e-9 * length);
    expect_same_vertices(envelope, 1e-9);
}

TEST_F(RemeshedSeams, LeavesADesignedEnvelopeBitByBit) {
    Envelope envelope = make_envelope(design_natural({}), {});
    const Envelope before = envelope;
    EXPECT_TRUE(remesh_envelope(envelope, automatic).empty());
    for (std::size_t t = 0; t < before.tiles.size(); ++t) {
        EXPECT_EQ(envelope.tiles[t].mesh.positions, before.tiles[t].mesh.positions);
        EXPECT_EQ(envelope.tiles[t].mesh.triangles, before.tiles[t].mesh.triangles);
        EXPECT_FALSE(envelope.tiles[t].remeshed);
    }
}

TEST_F(RemeshedSeams, IsTheSameOnAnyNumberOfThreads) {
    const Envelope input = make_envelope(meshed_apart(small_design(), 3, 6), {});
    Envelope one = input, four = input;
    RemeshOptions options = by_length(0.8);
    options.threads = 1;
    remesh_envelope(one, options);
    options.threads = 4;
    remesh_envelope(four, options);
    for (std::size_t t = 0; t < input.tiles.size(); ++t) {
        EXPECT_EQ(one.tiles[t].mesh.positions, four.tiles[t].mesh.positions);
        EXPECT_EQ(one.tiles[t].mesh.triangles, four.tiles[t].mesh.triangles);
    }
}

}  // namespace remesh_seams_test
}  // namespace ripstop
