/// Tiles with edges far shorter than the others: blunt tips of gores, steps in an outline.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/flatten/seam/seam_exact.h"
#include "ripstop/measure/judge.h"
#include "ripstop/measure/measure_accuracy.h"
#include "ripstop/measure/measure_bounds.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/tile/make_tile.h"
#include "support/shapes.h"

namespace ripstop {
namespace short_edges_test {

constexpr double pi = std::numbers::pi;
constexpr double radius = 5;  // [m]

/// One of 24 gores of a sphere, whose tips are edges of these widths at the south and the north pole; 0: a point.
TriangleMesh blunt_gore(double south, double north, int columns, int rows) {
    TriangleMesh mesh = testing::scaled(testing::lune(2 * pi / 24, columns, rows), radius);
    if (south == 0 && north == 0) return mesh;
    const double to_radius = 24 / (2 * pi);
    TriangleMesh open = testing::grid(columns, rows, [&](double u, double v) {
        const double longitude = 2 * pi / 24 * (u - 0.5), latitude = pi * (v - 0.5);
        const double tip = v == 0 ? south * to_radius : v == 1 ? north * to_radius : 0;
        const double r = std::max(radius * std::cos(latitude), tip);
        return Vec3(r * std::cos(longitude), r * std::sin(longitude), radius * std::sin(latitude));
    });
    if (south > 0 && north > 0) return open;
    // all vertices of a pointed tip are one
    const int first = south == 0 ? 0 : rows * (columns + 1);
    std::vector<Eigen::RowVector3i> triangles;
    for (int t = 0; t < open.triangle_count(); ++t) {
        Eigen::RowVector3i corners = open.triangles.row(t);
        for (int k = 0; k < 3; ++k) {
            if (corners[k] > first + columns)
                corners[k] -= columns;
            else if (corners[k] >= first)
                corners[k] = first;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            triangles.push_back(corners);
    }
    Points3 positions(open.vertex_count() - columns, 3);
    positions.topRows(first + 1) = open.positions.topRows(first + 1);
    positions.bottomRows(positions.rows() - first - 1) = open.positions.bottomRows(positions.rows() - first - 1);
    open.positions = positions;
    open.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t) open.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
    return open;
}

struct Result {
    Flattening flat;
    Accuracy accuracy;
    Verdict verdict;
};

Result flattened(const TriangleMesh& mesh, const Vec3& warp) {
    const Tile tile = make_tile("gore", mesh, {.warp = warp});
    Result result{flatten_seam_exact(tile, Fabric{}), {}, {}};
    result.accuracy = measure_accuracy(tile, result.flat.positions, Fabric{});
    result.verdict = judge(tile, measure_bounds(tile), result.flat, result.accuracy, tolerances_of(Fabric{}));
    return result;
}

void expect_sound(const Result& result) {
    EXPECT_EQ(result.flat.summary.termination, Termination::converged) << result.flat.summary.text();
    EXPECT_TRUE(result.flat.certificate && result.flat.certificate->strict_minimum);
    for (const Finding& finding : result.verdict.findings) ADD_FAILURE() << finding.code << ": " << finding.message;
}

TEST(ShortEdges, BluntTipsAreCutAsPoints) {
    for (const int columns : {1, 2, 3})
        for (const int rows : {8, 16}) {
            const Result pointed = flattened(blunt_gore(0, 0, columns, rows), Vec3::UnitZ());
            expect_sound(pointed);
            for (const double tip : {0.013, 0.13, 0.4, 4.0}) {
                SCOPED_TRACE(format_shortest(tip) + " mm, " + std::to_string(columns) + " x " + std::to_string(rows));
                for (const bool both : {true, false}) {
                    const double width = tip * millimetre;
                    const Result blunt = flattened(blunt_gore(both ? width : 0, width, columns, rows), Vec3::UnitZ());
                    if (tip == 0.013 && columns == 3 && rows == 8 &&
                        !blunt.verdict.manufacturable()) {  // needles of 1 in 10000 prevent it, and it says so
                        EXPECT_THAT(blunt.flat.summary.reason, ::testing::HasSubstr("of the way to their lengths"));
                        continue;
                    }
                    expect_sound(blunt);
                    // the tip's width relative to the gore's 1.3 m
                    EXPECT_NEAR(blunt.accuracy.area_error, pointed.accuracy.area_error, 1e-5 + width * 1e-3);
                }
            }
        }
}

/// A patch of a sphere whose outline has a step of this size in the middle of a side.
TriangleMesh with_step(TriangleMesh mesh, double step) {
    // the vertex in the middle of the side y = low, its two boundary neighbours, and the inner vertex above it
    const int side = static_cast<int>(std::lround(std::sqrt(mesh.vertex_count()))), v = side / 2, inside = v + side;
    const int extra = mesh.vertex_count();
    const Vec3 along = (mesh.positions.row(v + 1) - mesh.positions.row(v)).normalized();
    const Vec3 inward = (mesh.positions.row(inside) - mesh.positions.row(v)).normalized();
    Points3 positions(extra + 1, 3);
    positions << mesh.positions, mesh.positions.row(v) + step / std::sqrt(2.0) * (along + inward).transpose();
    // the triangles right of the edge to `inside` get the new vertex; one needle lies between the two
    Triangles triangles(mesh.triangle_count() + 1, 3);
    triangles.topRows(mesh.triangle_count()) = mesh.triangles;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
        if ((middle - mesh.positions.row(v).transpose()).dot(along) <= 0) continue;
        for (int k = 0; k < 3; ++k)
            if (triangles(t, k) == v) triangles(t, k) = extra;
    }
    triangles.bottomRows(1) << v, extra, inside;
    return {positions, triangles};
}

TEST(ShortEdges, StepInAnOutlineIsCutAsItIs) {
    for (const int n : {8, 16}) {
        const TriangleMesh patch = testing::spherical_square(0.1, n);
        const double plain = flattened(patch, Vec3::UnitX()).accuracy.area_error;
        for (const double step : {0.001, 0.05, 0.5}) {
            SCOPED_TRACE(format_shortest(step) + " mm, " + std::to_string(n));
            const Result result = flattened(with_step(patch, step * millimetre), Vec3::UnitX());
            expect_sound(result);
            EXPECT_NEAR(result.accuracy.area_error, plain, 2e-4);
        }
    }
}

}  // namespace short_edges_test
}  // namespace ripstop
