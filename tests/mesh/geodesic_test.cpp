#include "ripstop/mesh/geodesic.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "ripstop/geometry/triangle.h"
#include "support/shapes.h"

namespace ripstop {
namespace geodesic_test {

/// An irregularly meshed plane, so that walks cross edges at all angles.
TriangleMesh jittered_plane() {
    TriangleMesh mesh = testing::rectangle(2, 1, 20, 10);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-0.02, 0.02);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        const bool inside = mesh.positions(v, 0) > 0.01 && mesh.positions(v, 0) < 1.99 && mesh.positions(v, 1) > 0.01 &&
                            mesh.positions(v, 1) < 0.99;
        if (inside) mesh.positions.row(v) += Eigen::RowVector3d(jitter(random), jitter(random), 0);
    }
    return mesh;
}

Vec2 direction_in(const UnfoldedSurface& surface, int triangle, double x, double y, double z) {
    return surface.along(triangle, Vec3(x, y, z));
}

TEST(Walk, IsAStraightLineOnAPlane) {
    const UnfoldedSurface surface(jittered_plane());
    const SurfacePoint start = surface.nearest(Vec3(1, 0.5, 0));
    for (int k = 0; k < 24; ++k) {
        const double angle = k * std::numbers::pi / 12;
        const Vec3 along(std::cos(angle), std::sin(angle), 0);
        const Walk walk = surface.walk(start, direction_in(surface, start.triangle, along.x(), along.y(), 0), 0.45);
        EXPECT_FALSE(walk.hit_boundary);
        EXPECT_DOUBLE_EQ(walk.walked, 0.45);
        EXPECT_LT((surface.position(walk.end) - Vec3(1, 0.5, 0) - 0.45 * along).norm(), 1e-12);
        EXPECT_LT((walk.direction - surface.along(walk.end.triangle, along)).norm(), 1e-12);
    }
}

TEST(Walk, IsAHelixOnAPrism) {
    const int facets = 12;
    const double angle = 1.2;
    const UnfoldedSurface surface(testing::cylinder(1, angle, 2, facets, 16));
    const double width = 2 * std::sin(angle / 2 / facets);  // of a facet; laid flat, the prism has 12 facets
    const auto on_prism = [&](double x, double z) {
        const double facet = std::floor(x / width);
        const auto edge = [&](double k) {
            return Vec3(std::cos(angle * (k / facets - 0.5)), std::sin(angle * (k / facets - 0.5)), z);
        };
        const double part = x / width - facet;
        return Vec3((1 - part) * edge(facet) + part * edge(facet + 1));
    };
    const SurfacePoint start = surface.nearest(on_prism(2.3 * width, 0.31));
    const Vec3 facet_axis = (on_prism(2.4 * width, 0) - on_prism(2.3 * width, 0)).normalized();
    const double slope = 0.9;
    const Vec3 along = std::cos(slope) * facet_axis + std::sin(slope) * Vec3::UnitZ();
    const double length = 1.3;
    const Walk walk = surface.walk(start, surface.along(start.triangle, along), length);
    const Vec3 expected = on_prism(2.3 * width + length * std::cos(slope), 0.31 + length * std::sin(slope));
    EXPECT_LT((surface.position(walk.end) - expected).norm(), 1e-12);
}

TEST(Walk, KeepsToThePlaneOfAConeLaidFlat) {
    const int facets = 16;
    const double half = 0.5;
    const double angle = 2;
    const UnfoldedSurface surface(testing::cone(half, angle, 1, 2.5, facets, 12));
    // Laid flat about its tip, the polyhedral cone is a fan of equal triangles with this angle.
    const double fan = 2 * std::asin(std::sin(half) * std::sin(angle / 2 / facets));
    const auto ruling = [&](double k) {
        const double phi = angle * (k / facets - 0.5);
        return Vec3(std::sin(half) * std::cos(phi), std::sin(half) * std::sin(phi), -std::cos(half));
    };
    const auto laid_flat = [&](const Vec3& p) {
        const double facet = std::floor((std::atan2(p.y(), p.x()) / angle + 0.5) * facets);
        const double polar = facet * fan + angle_at(Vec3::Zero(), ruling(facet), p);
        return Vec2(p.norm() * std::cos(polar), p.norm() * std::sin(polar));
    };
    const Vec3 from = 1.9 * (0.6 * ruling(4) + 0.4 * ruling(5));
    const SurfacePoint start = surface.nearest(from);
    const Vec2 flat = laid_flat(from);
    const Vec3 ahead = from + 0.01 * (ruling(5) - ruling(4)) - 0.001 * ruling(4);  // in the same facet
    const Walk walk = surface.walk(start, surface.along(start.triangle, ahead - from), 0.7);
    ASSERT_FALSE(walk.hit_boundary);
    const Vec2 expected = flat + 0.7 * (laid_flat(ahead) - flat).normalized();
    EXPECT_LT((laid_flat(surface.position(walk.end)) - expected).norm(), 1e-11);  // the direction is a small difference
}

TEST(Walk, FollowsAGreatCircleToSecondOrder) {
    const UnfoldedSurface surface(testing::spherical_square(0.3, 40));
    const SurfacePoint start = surface.nearest(Vec3(0.003, 0.001, 1));
    const Vec3 from = surface.position(start).normalized();
    const Vec3 along = Vec3(1, 0.6, 0).cross(from).normalized();
    const Walk walk = surface.walk(start, surface.along(start.triangle, along), 0.25);
    const Vec3 expected = std::cos(0.25) * from + std::sin(0.25) * along;
    const double edge = 0.6 / 40;
    EXPECT_LT((surface.position(walk.end) - expected).norm(), edge * edge);
}

TEST(Walk, StopsAtTheBoundaryAndSaysSo) {
    const UnfoldedSurface surface(jittered_plane());
    const SurfacePoint start = surface.nearest(Vec3(0.5, 0.5, 0));
    const Walk walk = surface.walk(start, direction_in(surface, start.triangle, 3, 0, 0), 100);
    EXPECT_TRUE(walk.hit_boundary);
    EXPECT_NEAR(walk.walked, 1.5, 1e-12);
    EXPECT_LT((surface.position(walk.end) - Vec3(2, 0.5, 0)).norm(), 1e-12);
}

TEST(Walk, LeavesAVertexInEveryDirection) {
    const TriangleMesh mesh = testing::rectangle(2, 2, 4, 4);
    const UnfoldedSurface surface(mesh);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        for (int k = 0; k < 3; ++k) {
            const Vec3 vertex = mesh.corner(t, k);
            if (mesh.triangles(t, k) != 12) continue;  // the middle vertex
            for (int turn = 0; turn < 8; ++turn) {     // along edges and between them
                const double angle = turn * std::numbers::pi / 4;
                const Vec3 along(std::cos(angle), std::sin(angle), 0);
                const Walk walk = surface.walk({t, surface.corner(t, k)}, surface.along(t, along), 0.9);
                EXPECT_FALSE(walk.hit_boundary);
                EXPECT_LT((surface.position(walk.end) - vertex - 0.9 * along).norm(), 1e-12) << t << " " << turn;
            }
        }
}

TEST(Walk, RunsAlongABoundaryEdgeWithoutFallingOff) {
    const UnfoldedSurface surface(testing::rectangle(2, 1, 12, 6));
    const SurfacePoint start = surface.nearest(Vec3(0.05, 0, 0));
    const Walk walk = surface.walk(start, direction_in(surface, start.triangle, 1, 0, 0), 1.5);
    EXPECT_FALSE(walk.hit_boundary);
    EXPECT_LT((surface.position(walk.end) - Vec3(1.55, 0, 0)).norm(), 1e-12);
}

TEST(Walk, ComesBackToWhereItStarted) {
    const UnfoldedSurface surface(testing::saddle(1, 0.4, 12));
    const SurfacePoint start = surface.nearest(Vec3(0.05, -0.03, 0));
    for (int k = 0; k < 7; ++k) {
        const Vec2 along(std::cos(0.9 * k), std::sin(0.9 * k));
        const Walk there = surface.walk(start, along, 0.3);
        const Walk back = surface.walk(there.end, -there.direction, 0.3);
        EXPECT_LT((surface.position(back.end) - surface.position(start)).norm(), 1e-12);
        ASSERT_EQ(back.end.triangle, start.triangle);
        EXPECT_LT((back.direction + along).norm(), 1e-11);
    }
}

TEST(Walk, IsTheSameInOnePieceOrTwo) {
    const UnfoldedSurface surface(testing::saddle(1, 0.4, 12));
    const SurfacePoint start = surface.nearest(Vec3(0.05, -0.03, 0));
    const Walk whole = surface.walk(start, Vec2(0.3, 0.8), 0.25);
    const Walk first = surface.walk(start, Vec2(0.3, 0.8), 0.1);
    const Walk second = surface.walk(first.end, first.direction, 0.15);
    EXPECT_LT((surface.position(whole.end) - surface.position(second.end)).norm(), 1e-13);
}

/// Looking and walking are implemented independently: walking in a direction must reach what was seen there.
TEST(LookAround, SeesWhatAWalkMeets) {
    for (const TriangleMesh& mesh : {testing::saddle(1, 0.4, 12), testing::cap(0.8, 10), jittered_plane()}) {
        const UnfoldedSurface surface(mesh);
        const SurfacePoint from = surface.at(mesh.triangle_count() / 3, Vec3(0.2, 0.5, 0.3));
        int met = 0;
        for (const Sight& sight : surface.look_around(from, 0.3)) {
            const SurfacePoint middle = surface.at(sight.triangle, Vec3::Constant(1.0 / 3));
            const Vec2 seen = sight.unfolded(middle.local);
            if (sight.hidden_by(seen) > 0) continue;
            const Vec2 ray = seen - from.local;
            if (ray.norm() == 0) continue;
            const Walk walk = surface.walk(from, ray, ray.norm());
            EXPECT_EQ(walk.end.triangle, sight.triangle);
            EXPECT_LT((walk.end.local - middle.local).norm(), 1e-12);
            ++met;
        }
        EXPECT_GT(met, 20);
    }
}

TEST(LookAround, SeesEveryPlaceOfAPlaneOnceAndWhereItIs) {
    const TriangleMesh mesh = jittered_plane();
    const UnfoldedSurface surface(mesh);
    const SurfacePoint from = surface.nearest(Vec3(1, 0.5, 0));
    std::vector<int> seen(static_cast<std::size_t>(mesh.triangle_count()), 0);
    for (const Sight& sight : surface.look_around(from, 0.3)) {
        const SurfacePoint middle = surface.at(sight.triangle, Vec3::Constant(1.0 / 3));
        const Vec2 point = sight.unfolded(middle.local);
        if (sight.hidden_by(point) > 0) continue;
        ++seen[static_cast<std::size_t>(sight.triangle)];
        EXPECT_LT(
            (surface.along(from.triangle, surface.position(middle) - Vec3(1, 0.5, 0)) - (point - from.local)).norm(),
            1e-13);
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
        if ((middle - Vec3(1, 0.5, 0)).norm() < 0.3) {
            EXPECT_EQ(seen[static_cast<std::size_t>(t)], 1) << t;
        }
    }
}

TEST(LookAround, DoesNotSeeRoundACorner) {
    // Three quarters of a square: seen from one arm, the end of the other is behind the inner corner.
    TriangleMesh mesh = testing::rectangle(2, 2, 10, 10);
    Triangles kept(mesh.triangle_count(), 3);
    int count = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
        if (middle.x() < 1 || middle.y() < 1) kept.row(count++) = mesh.triangles.row(t);
    }
    mesh.triangles = kept.topRows(count);
    const UnfoldedSurface surface(mesh);
    const SurfacePoint from = surface.nearest(Vec3(0.5, 1.9, 0));
    for (const Sight& sight : surface.look_around(from, 10)) {
        const Vec2 point = sight.unfolded(surface.at(sight.triangle, Vec3::Constant(1.0 / 3)).local);
        const Vec3 place = surface.position(surface.at(sight.triangle, Vec3::Constant(1.0 / 3)));
        // The line from (0.5, 1.9) through the inner corner (1, 1).
        const bool behind = place.x() > 1 && place.y() > 1.9 - 1.8 * (place.x() - 0.5) + 1e-9;
        if (behind) {
            EXPECT_GT(sight.hidden_by(point), 0) << place.transpose();
        }
    }
}

TEST(SurfacePoint, ConvertsToBarycentricAndSpace) {
    const TriangleMesh mesh = testing::saddle(1, 0.4, 4);
    const UnfoldedSurface surface(mesh);
    const Vec3 weights(0.2, 0.5, 0.3);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
        const SurfacePoint point = surface.at(t, weights);
        EXPECT_LT((surface.barycentric(point) - weights).norm(), 1e-13);
        const Vec3 expected = 0.2 * mesh.corner(t, 0) + 0.5 * mesh.corner(t, 1) + 0.3 * mesh.corner(t, 2);
        EXPECT_LT((surface.position(point) - expected).norm(), 1e-14);
        EXPECT_LT((surface.position(surface.nearest(expected)) - expected).norm(), 1e-14);
    }
    EXPECT_LT((surface.position(surface.nearest(Vec3(9, 9, 0))) - Vec3(0.4, 0.4, 0)).norm(), 1e-14);
}

}  // namespace geodesic_test
}  // namespace ripstop
