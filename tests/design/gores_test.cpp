#include "ripstop/design/natural/gores.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "ripstop/base/error.h"
#include "ripstop/design/natural/design_summary.h"
#include "ripstop/mesh/adjacency.h"
#include "ripstop/mesh/disk.h"
#include "ripstop/model/tile/tile.h"
#include "ripstop/tile/make_tile.h"
#include "support/refusal.h"

namespace ripstop {
namespace gores_test {

using ::testing::HasSubstr;

EnvelopeDesign coarse() {
    EnvelopeDesign design;
    design.edge_length = 0.4;
    return design;
}

/// Designs of different kinds; every property must hold for each.
std::vector<EnvelopeDesign> kinds() {
    std::vector<EnvelopeDesign> all(8, coarse());
    all[1].crown_radius = 0;
    all[2].crown_radius = 0;
    all[2].mouth_ratio = 0;
    all[3].bulge = 30 * degree;
    all[4].bulge = 30 * degree;
    all[4].crown_radius = 0;
    all[5].gores = 3;
    all[5].panels = 4;
    all[6].gores = 8;
    all[6].panels = 5;
    all[6].crown_radius = 2;
    all[7].edge_length = 3;  // longer than a panel
    return all;
}

using Place = std::array<double, 3>;

std::set<Place> boundary_places(const NamedMesh& tile) {
    std::set<Place> places;
    const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
    for (const int v : require_disk(tile.mesh, adjacency, tile.name))
        places.insert({tile.mesh.positions(v, 0), tile.mesh.positions(v, 1), tile.mesh.positions(v, 2)});
    return places;
}

std::size_t shared(const NamedMesh& a, const NamedMesh& b) {
    const auto p = boundary_places(a);
    const auto q = boundary_places(b);
    std::vector<Place> both;
    std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
    return both.size();
}

std::string refusal(const EnvelopeDesign& design) {
    return testing::refusal([&] { design_natural(design); });
}

TEST(DesignNatural, NamesPanelsFromTheMouthUpGoreByGore) {
    const std::vector<NamedMesh> tiles = design_natural(coarse());
    ASSERT_EQ(tiles.size(), 360u);
    EXPECT_EQ(tiles[0].name, "G01P01");
    EXPECT_EQ(tiles[1].name, "G01P02");
    EXPECT_EQ(tiles[15].name, "G02P01");
    EXPECT_EQ(tiles[359].name, "G24P15");
    const NaturalShape shape = design_shape(coarse());
    EXPECT_DOUBLE_EQ(tiles[0].mesh.positions.col(2).minCoeff(), 0);
    EXPECT_NEAR(tiles[0].mesh.positions.leftCols<2>().rowwise().norm().minCoeff(), shape.mouth_radius, 1e-12);
    for (std::size_t i = 1; i < 15; ++i) EXPECT_GT(centroid(tiles[i].mesh).z(), centroid(tiles[i - 1].mesh).z());
}

TEST(DesignNatural, NamesWidenWhereThereAreMany) {
    EnvelopeDesign design = coarse();
    design.gores = 120;
    design.panels = 3;
    const std::vector<NamedMesh> tiles = design_natural(design);
    EXPECT_EQ(tiles.front().name, "G001P01");
    EXPECT_EQ(tiles.back().name, "G120P03");
}

TEST(DesignNatural, EveryTileIsADiskThatFacesOutward) {
    for (const EnvelopeDesign& design : kinds())
        for (const NamedMesh& tile : design_natural(design)) {
            const TriangleMesh& mesh = tile.mesh;
            EXPECT_NO_THROW(require_disk(mesh, Adjacency(mesh.triangles, mesh.vertex_count()), tile.name));
            const Vec3 within(0, 0, centroid(mesh).z() * 0.5 + 4);
            EXPECT_GT(area_vector(mesh).dot(centroid(mesh) - within), 0) << tile.name;
        }
}

TEST(DesignNatural, EveryTileHasFourCornersOrThreeAtAPoint) {
    for (const EnvelopeDesign& design : kinds()) {
        const std::vector<NamedMesh> tiles = design_natural(design);
        const std::size_t panels = tiles.size() / static_cast<std::size_t>(design.gores);
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const bool at_point =
                (i % panels == 0 && design.mouth_ratio == 0) || (i % panels == panels - 1 && design.crown_radius == 0);
            EXPECT_EQ(make_tile(tiles[i].name, tiles[i].mesh).chains.size(), at_point ? 3u : 4u) << tiles[i].name;
        }
    }
}

TEST(DesignNatural, NoInnerEdgeJoinsTwoBoundaryVertices) {
    for (const EnvelopeDesign& design : kinds())
        for (const NamedMesh& tile : design_natural(design)) {
            const Adjacency adjacency(tile.mesh.triangles, tile.mesh.vertex_count());
            std::vector<bool> boundary(static_cast<std::size_t>(tile.mesh.vertex_count()), false);
            for (const int v : require_disk(tile.mesh, adjacency, tile.name))
                boundary[static_cast<std::size_t>(v)] = true;
            for (const int h : adjacency.edges())
                if (!adjacency.is_boundary(h)) {
                    EXPECT_FALSE(boundary[static_cast<std::size_t>(adjacency.from(h))] &&
                                 boundary[static_cast<std::size_t>(adjacency.to(h))])
                        << tile.name;
                }
        }
}

TEST(DesignNatural, NeighboursShareTheirSeamsBitForBit) {
    for (const double bulge : {0.0, 30 * degree}) {
        EnvelopeDesign design = coarse();
        design.bulge = bulge;
        const std::vector<NamedMesh> tiles = design_natural(design);
        for (std::size_t gore = 0; gore < 24; ++gore)
            for (std::size_t panel : {0u, 7u, 14u}) {
                const NamedMesh& tile = tiles[gore * 15 + panel];
                const NamedMesh& right = tiles[(gore + 1) % 24 * 15 + panel];
                const Tile whole = make_tile(tile.name, tile.mesh);
                // Chains of a four-cornered tile, from the lower left corner: mouth side, right, crown side, left.
                EXPECT_EQ(shared(tile, right), whole.chains[1].vertices.size()) << tile.name;
                if (panel == 14) continue;
                EXPECT_EQ(shared(tile, tiles[gore * 15 + panel + 1]), whole.chains[2].vertices.size()) << tile.name;
            }
    }
}

TEST(DesignNatural, WeldsToASurfaceWithTheRightOpenings) {
    for (const EnvelopeDesign& design : kinds()) {
        const std::vector<NamedMesh> tiles = design_natural(design);
        const DesignSummary summary = measure_design(design, tiles);
        const int openings = (design.mouth_ratio > 0) + (design.crown_radius > 0);
        EXPECT_EQ(summary.euler, 2 - openings);
        EXPECT_EQ(summary.openings, openings);
        const TriangleMesh whole = welded(tiles);
        EXPECT_TRUE(Adjacency(whole.triangles, whole.vertex_count()).irregular_edges().empty());
    }
}

TEST(DesignNatural, AreaAndVolumeConvergeWithTheSquareOfTheEdge) {
    EnvelopeDesign design;
    const NaturalShape shape = design_shape(design);
    const MeridianPoint top = shape.meridian.descent_to(design.crown_radius);
    std::array<double, 3> area{}, volume{};
    for (std::size_t i = 0; i < 3; ++i) {
        design.edge_length = 0.8 / std::pow(2, i);
        const DesignSummary summary = measure_design(design, design_natural(design));
        area[i] = top.area - summary.area;
        volume[i] = top.volume - summary.volume;
    }
    // The error falls to a quarter each time, except that rows and columns are integers.
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(area[i] / area[i + 1], 4, 0.8);
        EXPECT_NEAR(volume[i] / volume[i + 1], 4, 0.8);
    }
    EXPECT_LT(volume[2], 1e-3 * 3000);
    EXPECT_LT(area[2], 1e-3 * 1000);
}

double area_of_the_first_gore(const EnvelopeDesign& design) {
    const std::vector<NamedMesh> tiles = design_natural(design);
    double area = 0;
    for (int i = 0; i < design.panels; ++i) area += surface_area(tiles[static_cast<std::size_t>(i)].mesh);
    return area;
}

TEST(DesignNatural, LobedClothHasTheAreaOfItsEquation) {
    EnvelopeDesign design;
    design.bulge = 30 * degree;
    const double exact = design_shape(design).meridian.descent_to(design.crown_radius).area / design.gores;
    design.edge_length = 0.2;
    const double coarser = area_of_the_first_gore(design);
    design.edge_length = 0.1;
    const double finer = area_of_the_first_gore(design);
    EXPECT_NEAR((exact - coarser) / (exact - finer), 4, 0.8);
    EXPECT_NEAR(finer + (finer - coarser) / 3, exact, 1e-4 * exact);
}

TEST(DesignNatural, LobesBulgeByTheirSagittaAndHangOnTheTapes) {
    EnvelopeDesign design = coarse();
    design.bulge = 30 * degree;
    const NaturalShape shape = design_shape(design);
    const MeridianPoint equator = shape.meridian.equator();
    const double a = std::numbers::pi / 24;
    const double c = equator.r * std::sin(a);
    const Vec3 crest = design_point(design, equator, 5, 0);
    EXPECT_NEAR(crest.head<2>().norm(), equator.r * std::cos(a) + c * std::tan(15 * degree), 1e-12);
    const Vec3 nearly = design_point(design, equator, 5, 1 - 1e-12);
    EXPECT_LT((nearly - design_point(design, equator, 5, 1)).norm(), 1e-9);
    EXPECT_EQ(design_point(design, equator, 23, 1), design_point(design, equator, 0, -1));
}

TEST(DesignNatural, TrianglesAreWellShaped) {
    const EnvelopeDesign design;
    const std::vector<NamedMesh> tiles = design_natural(design);
    const DesignSummary summary = measure_design(design, tiles);
    EXPECT_GT(summary.angle_min, 30 * degree);
    EXPECT_LT(summary.edge_max, 1.4 * design.edge_length);
    // At the crown ring of 0.25 m radius each gore is 65 mm wide: one edge, then two of 33 mm.
    EXPECT_GT(summary.edge_min, 0.19 * design.edge_length);
    EXPECT_LT(summary.chord_error, 1e-3);
    EXPECT_LT(summary.turn_max, 3 * degree);
    EnvelopeDesign wide = design;
    wide.crown_radius = 2;
    EXPECT_GT(measure_design(wide, design_natural(wide)).edge_min, 0.75 * design.edge_length);
}

TEST(DesignNatural, AtAClosedPointAnglesAreHalfTheGores) {
    EnvelopeDesign design = coarse();
    design.crown_radius = 0;  // each gore ends in 15 degrees, which an inner edge halves
    EXPECT_GT(measure_design(design, design_natural(design)).angle_min, 7 * degree);
}

TEST(DesignNatural, EdgeLengthForAThousandTrianglesGivesThem) {
    EnvelopeDesign design;
    design.edge_length = edge_length_for(design, 1000);
    EXPECT_NEAR(design.edge_length, 0.080, 0.001);
    const DesignSummary summary = measure_design(design, design_natural(design));
    EXPECT_NEAR(summary.triangles / 360.0, 1000, 50);
}

TEST(DesignNatural, PanelHeightChoosesThePanels) {
    EnvelopeDesign design = coarse();
    design.panel_height = 1.4;
    const DesignSummary summary = measure_design(design, design_natural(design));
    EXPECT_EQ(summary.panels, 19);
    EXPECT_LE(summary.panel_height, 1.4);
    EXPECT_GT(summary.panel_height * 19 / 18, 1.4);
}

TEST(DesignNatural, TakesADiameterInsteadOfAVolume) {
    EnvelopeDesign design = coarse();
    design.diameter = 20;
    EXPECT_NEAR(measure_design(design, design_natural(design)).diameter, 20, 0.01);
    EXPECT_NEAR(design_shape(design).max_radius, 10, 1e-8);
}

TEST(DesignNatural, TakesLobesUpToSixtyDegrees) {
    EnvelopeDesign design = coarse();
    design.gores = 12;
    design.bulge = 60 * degree;
    EXPECT_EQ(design_natural(design).size(), 180u);
}

TEST(DesignNatural, GivesTheSameBytesEveryTime) {
    const std::vector<NamedMesh> once = design_natural(coarse());
    const std::vector<NamedMesh> again = design_natural(coarse());
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].mesh.positions, again[i].mesh.positions);
}

TEST(DesignNatural, RefusesOptionsOutOfRangeByName) {
    EnvelopeDesign design;
    design.gores = 2;
    EXPECT_THAT(refusal(design), HasSubstr("number of gores is 2; it must lie between 3 and 1000"));
    design = {};
    design.panels = 0;
    EXPECT_THAT(refusal(design), HasSubstr("number of panels is 0"));
    design = {};
    design.bulge = 61 * degree;
    EXPECT_THAT(refusal(design), HasSubstr("it must lie between 0 and 60 degrees"));
    design = {};
    design.edge_length = 0;
    EXPECT_THAT(refusal(design), HasSubstr("edge length is 0 m"));
    design = {};
    design.edge_length = 1e-3;
    EXPECT_THAT(refusal(design), HasSubstr("million triangles"));
    design = {};
    design.crown_radius = 9.3;
    EXPECT_THAT(refusal(design), HasSubstr("crown radius is 9.3 m"));
    design = {};
    design.volume = 1;
    EXPECT_THAT(refusal(design), HasSubstr("no natural shape exists for 1 m3"));
    design = {};
    design.air.inside = 10;
    EXPECT_THAT(refusal(design), HasSubstr("no lift"));
}

}  // namespace gores_test
}  // namespace ripstop
