#include "ripstop/design/special/special.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/design/tools/tiles_summary.h"
#include "ripstop/io/json/special_json.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"
#include "support/refusal.h"
#include "support/sanitized.h"

namespace ripstop {
namespace special_test {

using std::numbers::pi;
using ::testing::HasSubstr;
using ::testing::StartsWith;

SpecialPrimitive primitive(PrimitiveKind kind, int sectors, int rings, const std::string& name = "BODY") {
    SpecialPrimitive p;
    p.name = name;
    p.kind = kind;
    p.sectors = sectors;
    p.rings = rings;
    return p;
}

SpecialPrimitive sphere(double radius, int sectors, int rings, const std::string& name = "BODY") {
    SpecialPrimitive p = primitive(PrimitiveKind::ellipsoid, sectors, rings, name);
    p.radii = Vec3::Constant(radius);
    return p;
}

SpecialPrimitive torus() {
    SpecialPrimitive p = primitive(PrimitiveKind::torus, 12, 4);
    p.radius = 5;
    p.tube_radius = 1.5;
    return p;
}

SpecialPrimitive capsule() {
    SpecialPrimitive p = primitive(PrimitiveKind::capsule, 7, 5);
    p.radius = 1.5;
    p.length = 3;
    p.axis = Vec3(1, 2, 3);
    p.centre = Vec3(0.3, -2, 1);
    return p;
}

SpecialPrimitive cone(double top_radius) {
    SpecialPrimitive p = primitive(PrimitiveKind::cone, 6, 3);
    p.radius = 1.5;
    p.length = 3;
    p.top_radius = top_radius;
    return p;
}

SpecialShape shape_of(std::vector<SpecialPrimitive> primitives, double edge) {
    SpecialShape shape;
    shape.primitives = std::move(primitives);
    shape.edge_length = edge;
    return shape;
}

/// Spheres of radius 2 and 1.5, which meet in the circle x = 1.6 of radius 1.2.
SpecialShape two_spheres(double joint = 0) {
    SpecialPrimitive other = sphere(1.5, 6, 4, "OTHER");
    other.centre = Vec3(2.5, 0, 0);
    other.axis = Vec3::UnitX();
    SpecialShape shape = shape_of({sphere(2, 8, 4), other}, 0.25);
    shape.joint_radius = joint;
    return shape;
}

SpecialShape example() {
    std::ifstream in(RIPSTOP_SOURCE_DIR "/docs/special.example.json");
    return read_special_shape(in, "special.example.json");
}

/// Shapes of different kinds; every property must hold for each.
std::vector<SpecialShape> kinds() {
    SpecialShape open = shape_of({sphere(3, 8, 4)}, 0.4);
    open.mouth = -2.6;
    return {shape_of({sphere(9, 16, 6)}, 0.9),
            shape_of({torus()}, 0.5),
            shape_of({capsule()}, 0.3),
            shape_of({cone(0)}, 0.3),
            shape_of({cone(0.7)}, 0.3),
            two_spheres(),
            two_spheres(0.5),
            open};
}

std::string refusal(const SpecialShape& shape) {
    return testing::refusal([&] { design_special(shape); });
}

using Place = std::array<double, 3>;

/// The joint: places where tiles of both primitives meet.
std::vector<Vec3> joint_of(const std::vector<NamedMesh>& tiles, const std::string& one, const std::string& other) {
    std::map<Place, std::set<std::string>> owners;
    for (const NamedMesh& tile : tiles)
        for (const auto& p : tile.mesh.positions.rowwise())
            owners[{p[0], p[1], p[2]}].insert(tile.name.substr(0, tile.name.find("-S")));
    std::vector<Vec3> joint;
    for (const auto& [place, names] : owners)
        if (names.contains(one) && names.contains(other)) joint.emplace_back(place[0], place[1], place[2]);
    return joint;
}

TEST(DesignSpecial, CutsASphereIntoSectorsByRings) {
    const std::vector<NamedMesh> tiles = design_special(shape_of({sphere(9, 16, 6)}, 0.9));
    ASSERT_EQ(tiles.size(), 96U);
    EXPECT_EQ(tiles[0].name, "BODY-S01R01");
    EXPECT_EQ(tiles[1].name, "BODY-S01R02");
    EXPECT_EQ(tiles[95].name, "BODY-S16R06");
    EXPECT_EQ(measure_tiles(tiles).euler, 2);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const Vec3 middle = centroid(tiles[i].mesh);
        const double azimuth = std::atan2(middle.y(), middle.x());
        EXPECT_EQ(static_cast<std::size_t>((azimuth < 0 ? azimuth + 2 * pi : azimuth) / (2 * pi) * 16), i / 6);
        EXPECT_EQ(static_cast<std::size_t>(std::acos(-middle.z() / middle.norm()) / pi * 6), i % 6);
    }
}

TEST(DesignSpecial, CutsATorusIntoSectorsByRingsOfItsTube) {
    const std::vector<NamedMesh> tiles = design_special(shape_of({torus()}, 0.5));
    EXPECT_EQ(tiles.size(), 48U);
    EXPECT_EQ(measure_tiles(tiles).euler, 0);
    EXPECT_GT(centroid(tiles[0].mesh).z(), 0) << "rings count from the outermost circle up";
    EXPECT_GT(centroid(tiles[0].mesh).norm(), 5);
}

TEST(DesignSpecial, VolumeAndAreaConvergeWithTheSquareOfTheEdge) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const double slant = std::hypot(3, 0.8);
    const struct {
        SpecialPrimitive primitive;
        double edge, volume, area;
    } forms[] = {{sphere(9, 16, 6), 0.9, 4.0 / 3 * pi * 729, 4 * pi * 81},
                 {torus(), 0.5, 2 * pi * pi * 5 * 2.25, 4 * pi * pi * 7.5},
                 {capsule(), 0.3, pi * 2.25 * 3 + 4.0 / 3 * pi * 3.375, 4 * pi * 2.25 + 2 * pi * 1.5 * 3},
                 {cone(0), 0.3, pi * 2.25, pi * 2.25 + pi * 1.5 * std::hypot(3, 1.5)},
                 {cone(0.7), 0.3, pi * (2.25 + 1.05 + 0.49), pi * (2.25 + 0.49) + pi * 2.2 * slant}};
    for (const auto& form : forms) {
        SCOPED_TRACE(primitive_kind_names[static_cast<std::size_t>(form.primitive.kind)]);
        const TilesSummary coarse = measure_tiles(design_special(shape_of({form.primitive}, form.edge)));
        const TilesSummary fine = measure_tiles(design_special(shape_of({form.primitive}, form.edge / 2)));
        EXPECT_LT(coarse.volume, form.volume) << "chords lie within";
        // Half the edge length gives a quarter of the error, as far as the irregular triangles of both meshes are
        // similar.
        EXPECT_NEAR((form.volume - coarse.volume) / (form.volume - fine.volume), 4, 1);
        EXPECT_NEAR((form.area - coarse.area) / (form.area - fine.area), 4, 1.2);
        EXPECT_NEAR(fine.volume, form.volume, 0.005 * form.volume);
        EXPECT_NEAR(fine.area, form.area, 0.0025 * form.area);
    }
}

TEST(DesignSpecial, EveryVertexLiesOnTheSurface) {
    for (const NamedMesh& tile : design_special(shape_of({torus()}, 0.5)))
        for (const auto& p : tile.mesh.positions.rowwise())
            EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 5, p[2]), 1.5, 1e-9);
    SpecialPrimitive egg = sphere(1, 5, 3);
    egg.radii = Vec3(2, 3, 4);
    for (const NamedMesh& tile : design_special(shape_of({egg}, 0.5)))
        for (const auto& p : tile.mesh.positions.rowwise())
            EXPECT_NEAR(p[0] * p[0] / 4 + p[1] * p[1] / 9 + p[2] * p[2] / 16, 1, 1e-9);
}

TEST(DesignSpecial, SeamsLieOnTheirPlanes) {
    for (const NamedMesh& tile : design_special(shape_of({sphere(3, 7, 5)}, 0.4))) {
        const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
        for (const int v : require_disk(tile.mesh, adjacency, tile.name)) {
            const Vec3 p = tile.mesh.positions.row(v);
            const double sector = std::atan2(p.y(), p.x()) / (2 * pi) * 7;
            const double ring = std::acos(std::clamp(-p.z() / 3, -1.0, 1.0)) / pi * 5;
            const bool is_pole = std::hypot(p.x(), p.y()) < 1e-9;
            // Places between the rings come from a table of 4096 steps, with an error of a millionth of a metre.
            EXPECT_TRUE(is_pole || std::abs(sector - std::round(sector)) < 1e-8 ||
                        std::abs(ring - std::round(ring)) < 1e-5)
                << tile.name << ' ' << p.transpose();
        }
    }
}

TEST(DesignSpecial, TilesAreDisksThatMeetBitForBitAndFaceOutwards) {
    for (const SpecialShape& shape : kinds()) {
        const std::vector<NamedMesh> tiles = design_special(shape);
        std::set<std::string> names;
        for (const NamedMesh& tile : tiles) {
            EXPECT_NO_THROW(
                require_disk(tile.mesh, Adjacency(tile.mesh.triangles, tile.mesh.vertex_count()), tile.name));
            EXPECT_TRUE(names.insert(tile.name).second) << tile.name;
        }
        const TriangleMesh whole = welded(tiles);
        const Adjacency adjacency(whole.triangles, whole.vertex_count());
        EXPECT_TRUE(adjacency.irregular_edges().empty());
        EXPECT_EQ(boundary_loops(adjacency).size(), shape.mouth ? 1U : 0U);
        EXPECT_GT(measure_tiles(tiles).volume, 0);
    }
}

TEST(DesignSpecial, NoTriangleIsASliver) {
    for (const SpecialShape& shape : kinds()) {
        const TilesSummary summary = measure_tiles(design_special(shape));
        EXPECT_GT(summary.angle_min, 10 * degree);
        EXPECT_LT(summary.edge_max, 1.6 * shape.edge_length);
    }
}

TEST(DesignSpecial, JoinsSharplyOnTheCircleWhereTwoSpheresMeet) {
    const std::vector<NamedMesh> tiles = design_special(two_spheres());
    const std::vector<Vec3> joint = joint_of(tiles, "BODY", "OTHER");
    EXPECT_GT(joint.size(), 25U);
    for (const Vec3& p : joint) {
        EXPECT_NEAR(p.x(), 1.6, 1e-9);
        EXPECT_NEAR(std::hypot(p.y(), p.z()), 1.2, 1e-9);
    }
    for (const NamedMesh& tile : tiles)
        for (const auto& p : tile.mesh.positions.rowwise()) {
            const Vec3 from_other = Vec3(p) - Vec3(2.5, 0, 0);
            EXPECT_NEAR(std::min(Vec3(p).norm() - 2, from_other.norm() - 1.5), 0, 1e-9);
        }
    const auto cap = [](double radius, double height) { return pi * height * height * (radius - height / 3); };
    const double both = 4.0 / 3 * pi * (8 + 3.375) - cap(2, 0.4) - cap(1.5, 0.6);
    EXPECT_NEAR(measure_tiles(tiles).volume, both, 0.01 * both);  // chords lose a third of (edge / radius)²
}

TEST(DesignSpecial, RoundsAJointByItsRadius) {
    const double radius = 0.5;
    const std::vector<NamedMesh> tiles = design_special(two_spheres(radius));
    for (const NamedMesh& tile : tiles)
        for (const auto& p : tile.mesh.positions.rowwise()) {
            const double a = std::max(radius - (Vec3(p).norm() - 2), 0.0);
            const double b = std::max(radius - ((Vec3(p) - Vec3(2.5, 0, 0)).norm() - 1.5), 0.0);
            EXPECT_NEAR(std::hypot(a, b), radius, 1e-9);
        }
    for (const Vec3& p : joint_of(tiles, "BODY", "OTHER"))
        EXPECT_NEAR(p.norm() - 2, (p - Vec3(2.5, 0, 0)).norm() - 1.5, 1e-9) << "as far from both";
    EXPECT_GT(measure_tiles(tiles).volume, measure_tiles(design_special(two_spheres())).volume);
}

TEST(DesignSpecial, AMouthIsOneOpeningInItsPlane) {
    SpecialShape shape = shape_of({sphere(3, 8, 4)}, 0.3);
    shape.mouth = -2.4;
    const std::vector<NamedMesh> tiles = design_special(shape);
    const TilesSummary summary = measure_tiles(tiles);
    EXPECT_EQ(summary.euler, 1);
    EXPECT_EQ(summary.openings, 1);
    EXPECT_NEAR(summary.rim, 2 * pi * 1.8, 0.01 * 2 * pi * 1.8) << "radius sqrt(9 - 5.76)";
    double lowest = 0;
    for (const NamedMesh& tile : tiles) lowest = std::min(lowest, tile.mesh.positions.col(2).minCoeff());
    EXPECT_NEAR(lowest, -2.4, 1e-9);
}

TEST(DesignSpecial, AConeHasItsTipAndAFlatBase) {
    const std::vector<NamedMesh> tiles = design_special(shape_of({cone(0)}, 0.3));
    EXPECT_EQ(tiles.size(), 24U) << "6 sectors of 3 rings and a base";
    double top = 0;
    for (const NamedMesh& tile : tiles) {
        top = std::max(top, tile.mesh.positions.col(2).maxCoeff());
        if (!tile.name.ends_with("BASE")) continue;
        EXPECT_LT(tile.mesh.positions.col(2).cwiseAbs().maxCoeff(), 1e-9) << tile.name;
    }
    EXPECT_EQ(tiles[3].name, "BODY-S01BASE");
    EXPECT_NEAR(top, 3, 1e-9);
}

TEST(DesignSpecial, GivesSmallPiecesToTheirNeighbours) {
    const std::vector<NamedMesh> tiles = design_special(two_spheres());
    std::vector<double> areas;
    for (const NamedMesh& tile : tiles) areas.push_back(surface_area(tile.mesh));
    std::sort(areas.begin(), areas.end());
    EXPECT_GT(areas.front(), areas[areas.size() / 2] / 25);
}

TEST(DesignSpecial, TheExampleHasOneHandleAndFitsTheRoll) {
    RIPSTOP_TOO_LONG_SANITIZED();
    SpecialShape shape = example();
    shape.edge_length = 0.15;  // a third of the triangles, which does not affect this test
    const std::vector<NamedMesh> tiles = design_special(shape);
    const TilesSummary summary = measure_tiles(tiles);
    EXPECT_EQ(summary.euler, -1) << "2 less one opening and one handle";
    EXPECT_GT(tiles.size(), 200U);
    EXPECT_LT(tiles.size(), 300U);
    EXPECT_LT(summary.tile_width, 1.45) << "1.5 m less two allowances";
    EXPECT_GT(summary.angle_min, 5 * degree);
    SpecialShape closed = shape;
    closed.mouth.reset();
    EXPECT_EQ(measure_tiles(design_special(closed)).euler, 0);
}

TEST(DesignSpecial, TheSameShapeGivesTheSameBits) {
    const std::vector<NamedMesh> one = design_special(two_spheres());
    const std::vector<NamedMesh> other = design_special(two_spheres());
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].name, other[i].name);
        EXPECT_TRUE(one[i].mesh.positions == other[i].mesh.positions);
        EXPECT_TRUE(one[i].mesh.triangles == other[i].mesh.triangles);
    }
}

TEST(DesignSpecial, RefusesWhatCannotBeMade) {
    EXPECT_THAT(refusal(shape_of({}, 0.3)), HasSubstr("there are 0 primitives, expected 1 to 200"));
    EXPECT_THAT(refusal(shape_of({sphere(-1, 6, 3)}, 0.3)), HasSubstr("primitive 1 (BODY): the radius is -1000 mm"));
    EXPECT_THAT(refusal(shape_of({sphere(1, 6, 3)}, 0.6)),
                HasSubstr("the edge length of 600 mm is too coarse for it, expected at most 500 mm"));
    EXPECT_THAT(refusal(shape_of({sphere(1, 6, 3), sphere(1, 6, 3)}, 0.3)), HasSubstr("an earlier one has its name"));
    EXPECT_THAT(refusal(shape_of({sphere(1, 0, 3)}, 0.3)), HasSubstr("sectors is 0, expected 1 to 1000"));
    SpecialPrimitive ring = torus();
    ring.tube_radius = 5;
    EXPECT_THAT(refusal(shape_of({ring}, 0.5)), HasSubstr("or the torus has no hole"));
    EXPECT_THAT(refusal(shape_of({sphere(900, 6, 3)}, 0.3)), HasSubstr("asks for a grid of"));
    EXPECT_THAT(refusal(two_spheres(0.1)), HasSubstr("the joint radius of 100 mm is below the edge length of 250 mm"));
}

TEST(DesignSpecial, RefusesPrimitivesThatLieApartOrShowNowhere) {
    SpecialShape shape = two_spheres();
    shape.primitives[1].centre = Vec3(5, 0, 0);
    EXPECT_THAT(refusal(shape), HasSubstr("OTHER and BODY lie apart from each other"));
    shape.primitives[1].centre = Vec3(0.1, 0, 0);
    EXPECT_THAT(refusal(shape), HasSubstr("OTHER lies entirely inside the other primitives"));
}

TEST(DesignSpecial, RefusesAMouthThatMissesTheBodyOrOpensItTwice) {
    SpecialShape shape = shape_of({sphere(3, 8, 4)}, 0.4);
    shape.mouth = -3.5;
    EXPECT_THAT(refusal(shape), HasSubstr("the mouth at height -3500 mm misses the body, which reaches from -"));
    SpecialPrimitive upright = torus();
    upright.axis = Vec3::UnitX();
    shape = shape_of({upright}, 0.5);
    shape.mouth = 0;
    EXPECT_THAT(refusal(shape), HasSubstr("the mouth opens the body in 2 places, expected one"));
}

TEST(DesignSpecial, RefusesTilesThatNoSeamOpens) {
    EXPECT_THAT(refusal(shape_of({sphere(3, 1, 3)}, 0.4)), HasSubstr("give its primitive more sectors or rings"));
    EXPECT_THAT(refusal(shape_of({sphere(3, 1, 1)}, 0.4)), StartsWith("special shape: a tile cannot be laid flat"));
}

}  // namespace special_test
}  // namespace ripstop
