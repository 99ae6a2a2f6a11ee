#include "ripstop/mesh/disk.h"

#include <gmock/gmock.h>

#include "ripstop/base/error.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace ripstop {
namespace disk_test {

using ::testing::HasSubstr;

std::string refusal(const TriangleMesh& mesh) {
    return testing::refusal([&] { require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), "G01P01"); });
}

TEST(RequireDisk, GivesTheBoundaryCounterClockwise) {
    const TriangleMesh mesh = testing::rectangle(2, 1, 2, 1);
    const std::vector<int> boundary = require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), "tile");
    EXPECT_EQ(boundary, (std::vector<int>{0, 1, 2, 5, 4, 3}));
}

TEST(RequireDisk, AcceptsEveryTestShape) {
    for (const auto& shapes : {testing::developable_shapes(), testing::curved_shapes()})
        for (const auto& shape : shapes) EXPECT_EQ(refusal(shape.mesh), "accepted") << shape.name;
}

TEST(RequireDisk, RefusesAClosedSurface) {
    TriangleMesh mesh;
    mesh.positions.resize(4, 3);
    mesh.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    mesh.triangles.resize(4, 3);
    mesh.triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
    EXPECT_THAT(refusal(mesh), HasSubstr("tile G01P01: is closed"));
}

TEST(RequireDisk, RefusesAHoleAndSaysWhere) {
    TriangleMesh mesh = testing::rectangle(3, 3, 3, 3);
    Triangles kept(16, 3);
    kept << mesh.triangles.topRows(8), mesh.triangles.bottomRows(8);
    mesh.triangles = kept;
    EXPECT_THAT(refusal(mesh), HasSubstr("2 boundary loops"));
    EXPECT_THAT(refusal(mesh), HasSubstr("(1.0000, 1.0000, 0.0000) m"));
}

TEST(RequireDisk, RefusesATriangleTurnedRound) {
    TriangleMesh mesh = testing::rectangle(3, 3, 3, 3);
    std::swap(mesh.triangles(8, 0), mesh.triangles(8, 1));
    EXPECT_THAT(refusal(mesh), HasSubstr("face opposite ways"));
}

TEST(RequireDisk, RefusesTwoPiecesAndAPinch) {
    TriangleMesh mesh;
    mesh.positions.resize(6, 3);
    mesh.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 0, 6, 0, 0, 5, 1, 0;
    mesh.triangles.resize(2, 3);
    mesh.triangles << 0, 1, 2, 3, 4, 5;
    EXPECT_THAT(refusal(mesh), HasSubstr("more than one piece"));
    mesh.triangles << 0, 1, 2, 0, 4, 5;
    EXPECT_THAT(refusal(mesh), HasSubstr("belongs to no triangle"));
    mesh.positions.conservativeResize(5, 3);
    mesh.triangles << 0, 1, 2, 0, 3, 4;
    mesh.positions.row(4) << 3, 3, 0;
    EXPECT_THAT(refusal(mesh), HasSubstr("touch only in the point"));
}

TEST(RequireDisk, RefusesATriangleWithoutArea) {
    TriangleMesh mesh = testing::rectangle(1, 1, 2, 2);
    mesh.positions.row(4) = mesh.positions.row(0);
    EXPECT_THAT(refusal(mesh), HasSubstr("without area"));
}

TEST(RequireDisk, RefusesAMoebiusLikeStrip) {
    TriangleMesh mesh;
    mesh.positions.resize(5, 3);
    mesh.positions << 0, 0, 0, 1, 0, 0.1, 1, 1, 0, 0, 1, 0.3, -1, 0.5, 1;
    mesh.triangles.resize(5, 3);
    mesh.triangles << 0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 0, 4, 4, 0, 1;
    EXPECT_THAT(refusal(mesh), HasSubstr("tile G01P01: "));
}

}  // namespace disk_test
}  // namespace ripstop
