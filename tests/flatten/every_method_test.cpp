#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/flatten/method.h"
#include "ripstop/flatten/tools/grain.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/mesh/change/flips.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {

void PrintTo(const Method& method, std::ostream* out) {
    *out << method.name;
}

namespace every_method_test {

/// Properties of every method, whatever it minimises. Runs over the whole table of methods.
class EveryMethod : public ::testing::TestWithParam<Method> {
  protected:
    Fabric fabric;

    Tile tile(const TriangleMesh& mesh) const { return make_tile("tile", mesh, {.warp = Vec3(0.2, 1, 0.5)}); }
    Flattening flatten(const Tile& of) const { return GetParam().flatten(of, fabric); }
    Accuracy accuracy(const Tile& of) const { return measure_accuracy(of, flatten(of).positions, fabric); }
    /// A weave that starts from a planar projection is stretched there, and has not converged at its limit of
    /// sweeps.
    double developable_error() const { return std::string(GetParam().name) == "kub10" ? 1e-2 : 1e-7; }
    /// WireWarping lays out the outline only; its inner weights do not know angles.
    bool shapes_the_inside() const { return std::string(GetParam().name) != "wirewarping"; }
    /// How far different rounding may move a result; iterations that stop at rest differ by their stopping
    /// tolerance.
    double pose_tolerance() const { return 1e-3; }
};

/// The lengths of all edges, which do not depend on the placement on the cloth.
Eigen::VectorXd edge_lengths_of(const Triangles& triangles, const Points2& x) {
    Eigen::VectorXd lengths(3 * triangles.rows());
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
        for (int k = 0; k < 3; ++k)
            lengths[3 * t + k] = (x.row(triangles(t, (k + 1) % 3)) - x.row(triangles(t, k))).norm();
    return lengths;
}

TEST_P(EveryMethod, IsExactOnDevelopables) {
    for (const auto& shape : testing::developable_shapes()) {
        SCOPED_TRACE(shape.name);
        const Accuracy found = accuracy(tile(shape.mesh));
        EXPECT_LT(std::abs(found.area_error), developable_error());
        if (shapes_the_inside()) {
            EXPECT_LT(found.edge_error_abs, developable_error());
        }
        EXPECT_LT(found.boundary_error_max, 10 * developable_error());
    }
}

TEST_P(EveryMethod, TurnsNoTriangleOver) {
    for (const auto& shape : testing::curved_shapes()) {
        const Tile of = tile(shape.mesh);
        EXPECT_EQ(count_flipped(of.mesh.triangles, flatten(of).positions), 0) << shape.name;
    }
}

TEST_P(EveryMethod, LaysTheWarpAlongX) {
    for (const auto& shape : testing::curved_shapes()) {
        const Tile of = tile(shape.mesh);
        const Points2 x = flatten(of).positions;
        Points2 again = x;
        align_with_grain(of, again);
        EXPECT_LT((again - x).cwiseAbs().maxCoeff(), 1e-9) << shape.name;
    }
}

TEST_P(EveryMethod, GivesTheSameInAnyPose) {
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Tile there = make_tile("tile", shape.mesh, {.warp = shape.mesh.corner(0, 1) - shape.mesh.corner(0, 0)});
        const TriangleMesh turned = testing::moved(shape.mesh);
        const Tile elsewhere = make_tile("tile", turned, {.warp = turned.corner(0, 1) - turned.corner(0, 0)});
        const Flattening a = flatten(there), b = flatten(elsewhere);
        EXPECT_LT(
            (edge_lengths_of(shape.mesh.triangles, a.positions) - edge_lengths_of(shape.mesh.triangles, b.positions))
                .cwiseAbs()
                .maxCoeff(),
            pose_tolerance());
    }
}

TEST_P(EveryMethod, ScalesWithTheTile) {
    const auto shape = testing::curved_shapes().front();
    const Points2 small = flatten(tile(shape.mesh)).positions;
    const Points2 large = flatten(tile(testing::scaled(shape.mesh, 100))).positions;
    EXPECT_LT((large / 100 - small).cwiseAbs().maxCoeff(), pose_tolerance());
}

TEST_P(EveryMethod, GivesTheSameBytesTwice) {
    const Tile of = tile(testing::curved_shapes().back().mesh);
    EXPECT_EQ(flatten(of).positions, flatten(of).positions);
}

/// Tiles that no cloth is cut for: nearly closed, crumpled, made of slivers, without an inner vertex.
std::vector<testing::Shape> wild_shapes() {
    std::vector<testing::Shape> shapes = {{"nearly closed sphere", testing::cap(2.8, 8)},
                                          {"quarter sphere", testing::lune(std::numbers::pi / 2, 8, 16)},
                                          {"strip", testing::cylinder(1, 5, 0.1, 30, 1)},
                                          {"1:300", testing::rectangle(300, 1, 8, 8)}};
    TriangleMesh crumpled = testing::rectangle(1, 1, 9, 9);
    for (int v = 0; v < crumpled.vertex_count(); ++v) crumpled.positions(v, 2) = 0.3 * std::sin(7.0 * v * v);
    shapes.push_back({"crumpled", crumpled});
    TriangleMesh slivers = testing::rectangle(1, 1, 8, 8);
    for (int v = 0; v < slivers.vertex_count(); ++v)  // every second row of points almost coincides with the one before
        if (const int row = v / 9; row % 2 == 1) slivers.positions(v, 1) -= 0.125 * (1 - 1e-4);
    shapes.push_back({"slivers", slivers});
    return shapes;
}

TEST_P(EveryMethod, EndsOnAnyTileWithFinitePositionsAndAReason) {
    for (const auto& shape : wild_shapes()) {
        const Flattening flat = flatten(tile(shape.mesh));
        EXPECT_TRUE(flat.positions.allFinite()) << shape.name;
        EXPECT_FALSE(flat.summary.reason.empty() || flat.summary.reason == "not run") << shape.name;
        if (flat.summary.usable()) {
            EXPECT_EQ(flat.positions.rows(), shape.mesh.vertex_count()) << shape.name;
        }
    }
}

TEST_P(EveryMethod, FlattensASingleTriangle) {
    TriangleMesh mesh;
    mesh.positions.resize(3, 3);
    mesh.positions << 0, 0, 0, 2, 0, 1, 0, 1, 1;
    mesh.triangles.resize(1, 3);
    mesh.triangles << 0, 1, 2;
    const Accuracy found = accuracy(tile(mesh));
    EXPECT_LT(found.boundary_error_max, 1e-6);
    EXPECT_EQ(found.flipped, 0);
}

std::string test_name(const ::testing::TestParamInfo<Method>& tested) {
    std::string name = tested.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryMethod, ::testing::ValuesIn(methods().begin(), methods().end()), test_name);

TEST(Methods, TheDefaultHoldsTheSeamsOfCurvedTilesWhichNoFreeOutlineDoesAndWithLessStrainThanThoseThatDo) {
    const auto found = [](const Tile& tile, const char* method) {
        return measure_accuracy(tile, method_named(method).flatten(tile, Fabric{}).positions, Fabric{});
    };
    for (const auto& shape : testing::curved_shapes()) {
        SCOPED_TRACE(shape.name);
        const Tile tile = make_tile(shape.name, shape.mesh);
        const Accuracy ours = found(tile, methods().front().name);
        EXPECT_LT(ours.boundary_error_max, 1e-8);
        for (const char* const free : {"paper", "woven", "lscm", "arap", "dirichlet", "energy", "mccartney", "aono"})
            EXPECT_GT(found(tile, free).boundary_error_max, 1e-4) << free;
        for (const char* const held : {"bff", "wirewarping"}) EXPECT_GT(found(tile, held).energy, ours.energy) << held;
    }
}

TEST(Methods, AnUnknownNameIsAnsweredWithTheList) {
    try {
        method_named("foo");
        FAIL();
    } catch (const std::exception& error) {
        EXPECT_EQ(std::string(error.what()).rfind("no method \"foo\"; known: ", 0), 0u) << error.what();
    }
}

}  // namespace every_method_test
}  // namespace ripstop
