#include "ripstop/measure/walk_seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/mesh/boundary.h"
#include "ripstop/tile/make_tile.h"
#include "support/seams.h"
#include "support/shapes.h"

namespace ripstop {
namespace seam_walk_test {

const Tolerances tolerances;

/// A patch of the unit sphere between given longitudes and latitudes.
Tile patch(const std::string& name, double west, double east, double south, double north, int columns, int rows) {
    const auto map = [&](double u, double v) {
        const double longitude = west + u * (east - west), latitude = south + v * (north - south);
        return Vec3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                    std::sin(latitude));
    };
    const TriangleMesh mesh = testing::grid(columns, rows, map);
    const auto corner = [&](int i, int j) { return Vec3(mesh.positions.row(j * (columns + 1) + i)); };
    return make_tile(
        name, mesh,
        {.corners = {corner(0, 0), corner(columns, 0), corner(columns, rows), corner(0, rows)}, .warp = Vec3::UnitZ()});
}

double longitude(const Tile& tile, int vertex) {
    return std::atan2(tile.mesh.positions(vertex, 1), tile.mesh.positions(vertex, 0));
}

/// Measures the edges on the equator along it: one radian is one metre.
void measure_on_equator(Tile& tile) {
    tile.curve_lengths = edge_lengths(tile.mesh.positions, closed(tile.boundary));
    for (std::size_t i = 0; i < tile.boundary.size(); ++i) {
        const int a = tile.boundary[i], b = tile.boundary[(i + 1) % tile.boundary.size()];
        if (std::abs(tile.mesh.positions(a, 2)) < 1e-12 && std::abs(tile.mesh.positions(b, 2)) < 1e-12)
            tile.curve_lengths[static_cast<Eigen::Index>(i)] = std::abs(longitude(tile, b) - longitude(tile, a));
    }
}

/// The edges of a tile on the equator between two longitudes, as parts in the order of its boundary.
SeamSide along_equator(const std::vector<Tile>& tiles, int t, double west, double east) {
    const Tile& tile = tiles[static_cast<std::size_t>(t)];
    const auto lies_on_it = [&](const Chain& chain) {
        return std::all_of(chain.vertices.begin(), chain.vertices.end(),
                           [&](int v) { return std::abs(tile.mesh.positions(v, 2)) < 1e-12; });
    };
    const auto chain = std::find_if(tile.chains.begin(), tile.chains.end(), lies_on_it);
    SeamSide side{t, static_cast<int>(chain - tile.chains.begin()), {}};
    const std::vector<int>& vertices = chain->vertices;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        const auto [low, high] = std::minmax({longitude(tile, vertices[i]), longitude(tile, vertices[i + 1])});
        const double length = std::min(high, east) - std::max(low, west);
        const auto place = std::find(tile.boundary.begin(), tile.boundary.end(), vertices[i]) - tile.boundary.begin();
        if (length > 0) side.parts.push_back({static_cast<int>(place), length});
    }
    return side;
}

Seam seam_on_equator(const std::vector<Tile>& tiles, int north, int south, double west, double east) {
    Seam seam{"S", along_equator(tiles, north, west, east), along_equator(tiles, south, west, east)};
    seam.length = east - west;
    return seam;
}

/// One wide tile south of the equator and two north of it, which meet within one of its edges; each is meshed
/// independently.
std::vector<Tile> t_junction() {
    std::vector<Tile> tiles{patch("south", 0, 0.6, -0.3, 0, 7, 5), patch("north-west", 0, 0.23, 0, 0.3, 3, 6),
                            patch("north-east", 0.23, 0.6, 0, 0.3, 5, 4)};
    for (Tile& tile : tiles) measure_on_equator(tile);
    return tiles;
}

TEST(SeamWalk, SidesOfExactEdgesAgreeAcrossATJunctionHoweverTheyAreMeshed) {
    const std::vector<Tile> tiles = t_junction();
    std::vector<FlatTile> flat;
    for (const Tile& tile : tiles) {
        FlatTile& result = flat.emplace_back();
        result.tile = tile;
        result.flattening = flatten_seam_exact(tile, Fabric{});
        ASSERT_EQ(result.flattening.summary.termination, Termination::converged);
    }
    const std::vector<Seam> seams{seam_on_equator(tiles, 1, 0, 0, 0.23), seam_on_equator(tiles, 2, 0, 0.23, 0.6)};
    EXPECT_EQ(seams[0].b.parts.size(), 3u);
    EXPECT_EQ(seams[1].b.parts.size(), 5u) << "the edge the junction lies in belongs to both";
    EXPECT_EQ(seams[0].b.parts.front().edge, seams[1].b.parts.back().edge);
    for (const SeamWalk& walk : walk_seams(flat, seams, tolerances)) {
        EXPECT_LT(std::abs(walk.mismatch()), 1e-9);
        EXPECT_LT(walk.drift_max, 1e-9);
        EXPECT_NEAR(walk.flat_a, walk.length, 1e-9);
        EXPECT_TRUE(walk.ok);
    }
}

TEST(SeamWalk, ChordsOfOneCurveAreNoMismatchHoweverManyTheyAre) {
    // Both sides flattened exactly, by a method that knows only each tile's own mesh.
    std::vector<Tile> tiles{patch("south", 0, 0.6, -0.3, 0, 3, 5), patch("north", 0, 0.6, 0, 0.3, 11, 4)};
    for (Tile& tile : tiles) measure_on_equator(tile);
    const std::vector<Seam> seams{seam_on_equator(tiles, 1, 0, 0, 0.6)};
    const auto unrolled = [&](bool on_curve) {
        std::vector<FlatTile> flat;
        for (const Tile& tile : tiles) {
            Points2 positions = Points2::Zero(tile.mesh.vertex_count(), 2);
            for (int v = 0; v < tile.mesh.vertex_count(); ++v) {
                const double columns = tile.name == "south" ? 3 : 11;
                const double chord = 2 * std::sin(0.6 / columns / 2);
                positions.row(v) << longitude(tile, v) / (0.6 / columns) * chord, std::asin(tile.mesh.positions(v, 2));
            }
            flat.push_back(testing::flattened(tile, positions, on_curve));
        }
        return walk_seams(flat, seams, tolerances).front();
    };
    EXPECT_LT(std::abs(unrolled(false).mismatch()), 1e-12);
    EXPECT_NEAR(unrolled(false).flat_a, 0.6, 1e-12);
    EXPECT_TRUE(unrolled(false).ok);
    // As polylines they differ by the theta^2 / 24 of the coarse side minus that of the fine one.
    const double expected = 0.6 * (std::pow(0.6 / 11, 2) - std::pow(0.6 / 3, 2)) / 24;
    EXPECT_NEAR(unrolled(true).mismatch(), expected, 0.01 * std::abs(expected));
    EXPECT_FALSE(unrolled(true).ok);
}

/// Two unit squares side by side; flat positions as drawn.
struct Squares {
    Envelope envelope;
    std::vector<FlatTile> flat;

    Squares(int left_rows, int right_rows) {
        TriangleMesh right = testing::rectangle(1, 1, 4, right_rows);
        right.positions.col(0).array() += 1;
        envelope.tiles = {make_tile("left", testing::rectangle(1, 1, 4, left_rows), {.warp = Vec3::UnitX()}),
                          make_tile("right", right, {.warp = Vec3::UnitX()})};
        flat = testing::laid_flat(envelope);
        Seam seam{"S1", testing::run_of_chain(envelope, 0, 1, 0, left_rows),
                  testing::run_of_chain(envelope, 1, 3, 0, right_rows)};
        seam.length = 1;
        seam.uncertainty = 0.002;
        envelope.seams = {seam};
    }
    SeamWalk walk(const WalkOptions& options = {}) const {
        return walk_seams(flat, envelope.seams, tolerances, options).front();
    }
    /// Maps the heights of the right square.
    template <class Map>
    void bend(Map map) {
        for (Eigen::Index v = 0; v < flat[1].flattening.positions.rows(); ++v)
            flat[1].flattening.positions(v, 1) = map(flat[1].flattening.positions(v, 1));
    }
};

TEST(SeamWalk, MismatchIsSideBLessSideA) {
    Squares squares(4, 5);
    squares.bend([](double y) { return 1.003 * y; });
    const SeamWalk walk = squares.walk();
    EXPECT_NEAR(walk.flat_a, 1, 1e-14);
    EXPECT_NEAR(walk.mismatch(), 0.003, 1e-14);
    EXPECT_NEAR(walk.mismatch_ratio(), 0.003, 1e-14);
    EXPECT_NEAR(walk.drift_max, 0.003, 1e-14);
    EXPECT_NEAR(walk.drift_max_at, 1, 1e-14);
    EXPECT_NEAR(walk.limit, 0.001, 1e-15);
    EXPECT_EQ(walk.uncertainty, 0.002);
    EXPECT_FALSE(walk.ok);
}

TEST(SeamWalk, NotchesTellWhereADifferenceAccumulates) {
    Squares squares(4, 8);
    // Only the upper half is too long; the seam starts at the bottom, where side a starts.
    squares.bend([](double y) { return y + 0.004 * std::max(0.0, y - 0.5); });
    const SeamWalk walk = squares.walk();
    ASSERT_EQ(walk.notches.size(), 3u);
    EXPECT_NEAR(walk.notches[0].drift, 0, 1e-14);
    EXPECT_NEAR(walk.notches[1].drift, 0, 1e-14);
    EXPECT_NEAR(walk.notches[2].at, 0.75, 1e-14);
    EXPECT_NEAR(walk.notches[2].drift, 0.001, 1e-14);
    EXPECT_EQ(squares.walk({.notch_spacing = 0.1}).notches.size(), 9u);
    EXPECT_EQ(squares.walk({.notch_spacing = 5, .least_intervals = 2}).notches.size(), 1u);
}

TEST(SeamWalk, SidesThatEndTogetherButPartOnTheWayAreNotOk) {
    Squares squares(4, 10);
    squares.bend([](double y) { return y + (y > 0.25 && y < 0.35 ? 0.005 : 0); });
    const SeamWalk walk = squares.walk();
    EXPECT_NEAR(walk.mismatch(), 0, 1e-14);
    EXPECT_NEAR(walk.drift_max, 0.005, 1e-14);
    EXPECT_NEAR(walk.drift_max_at, 0.3, 1e-14) << "between two notches: the largest drift is found all the same";
    EXPECT_NEAR(walk.worst.y(), 0.375, 1e-14) << "the middle of side a's edge";
    EXPECT_FALSE(walk.ok);
}

TEST(SeamWalk, CompensationAlikeOnBothSidesIsNoMismatch) {
    Squares squares(4, 5);
    for (FlatTile& tile : squares.flat) tile.flattening.positions.col(1) *= 1.01;
    const SeamWalk walk = squares.walk();
    EXPECT_NEAR(walk.flat_a, 1.01, 1e-14);
    EXPECT_LT(walk.drift_max, 1e-14);
    EXPECT_TRUE(walk.ok);
}

TEST(SeamWalk, ATileIsSewnToItself) {
    // A cone of cloth closed along a ruling: its two straight edges are one seam.
    const double half = 0.4, angle = 6.283185307179586;
    const Tile cone = make_tile("cone", testing::cone(half, angle, 0.5, 2, 24, 6));
    ASSERT_EQ(cone.chains.size(), 4u);
    Envelope envelope{{cone}};
    Points2 fan(cone.mesh.vertex_count(), 2);
    for (int v = 0; v < cone.mesh.vertex_count(); ++v) {
        const double slant = 0.5 + 1.5 * (v / 25) / 6, turn = angle * std::sin(half) * (v % 25) / 24;
        fan.row(v) << slant * std::cos(turn), slant * std::sin(turn);
    }
    std::vector<int> straight;
    for (int c = 0; c < 4; ++c)
        if (cone.chains[static_cast<std::size_t>(c)].edge_count() == 6) straight.push_back(c);
    ASSERT_EQ(straight.size(), 2u);
    Seam seam{"S1", testing::run_of_chain(envelope, 0, straight[0], 0, 6),
              testing::run_of_chain(envelope, 0, straight[1], 0, 6)};
    seam.length = 1.5;
    const SeamWalk walk = walk_seams({testing::flattened(cone, fan)}, {seam}, tolerances).front();
    EXPECT_NEAR(walk.flat_a, 1.5, 1e-12);
    EXPECT_LT(walk.drift_max, 1e-12);
    EXPECT_TRUE(walk.ok);
}

TEST(SeamWalk, ASideThatWasNotFlattenedIsNotOk) {
    Squares squares(4, 5);
    squares.flat[1].flattening.positions = Points2();
    const SeamWalk walk = squares.walk();
    EXPECT_TRUE(std::isnan(walk.flat_b));
    EXPECT_NEAR(walk.flat_a, 1, 1e-14);
    EXPECT_FALSE(walk.ok);
}

}  // namespace seam_walk_test
}  // namespace ripstop
