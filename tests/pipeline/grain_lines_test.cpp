#include "ripstop/pipeline/read/grain_lines.h"

#include <gmock/gmock.h>

#include "ripstop/base/error.h"
#include "ripstop/pipeline/read/read_envelope.h"
#include "ripstop/tile/make_tile.h"
#include "ripstop/tile/targets.h"
#include "support/shapes.h"

namespace ripstop {
namespace grain_lines_test {

using ::testing::HasSubstr;

Points3 line(const Vec3& from, const Vec3& to) {
    Points3 points(2, 3);
    points << from.transpose(), to.transpose();
    return points;
}

/// Two sheets of 2 m x 1 m in the plane z = 0, the second from x = 3 on.
CadModel two_sheets() {
    CadModel model;
    for (const double x : {0.0, 3.0}) {
        TriangleMesh sheet = testing::rectangle(2, 1, 8, 4);
        sheet.positions.col(0).array() += x;
        model.surfaces.push_back({x == 0 ? "left" : "right", sheet});
    }
    return model;
}

NamedCurve on_layer(const std::string& layer, const Vec3& from, const Vec3& to) {
    return {"", line(from, to), {{"layer", layer}}};
}

TEST(GrainLine, IsKnownByItsLayerItsGroupOrItsNameInAnyCase) {
    for (const char* layer : {"GRAIN", "warp", "envelope::Grain", "Grain::crown"})
        EXPECT_TRUE(is_grain_line(on_layer(layer, {0, 0, 0}, {1, 0, 0}))) << layer;
    for (const char* layer : {"grainy", "artwork", "", "warp tension"})
        EXPECT_FALSE(is_grain_line(on_layer(layer, {0, 0, 0}, {1, 0, 0}))) << layer;
    EXPECT_TRUE(is_grain_line({"Warp", line({0, 0, 0}, {1, 0, 0}), {}}));
    EXPECT_TRUE(is_grain_line({"", line({0, 0, 0}, {1, 0, 0}), {{"group", "GRAIN"}}}));
}

TEST(GrainLine, GivesItsWayToTheTileItLiesOn) {
    CadModel model = two_sheets();
    model.curves.push_back(on_layer("GRAIN", {3.2, 0.2, 0.001}, {3.6, 0.6, 0.001}));
    EXPECT_TRUE(lay_grain_lines(model).empty());
    const Envelope envelope = [&] {
        ReadOptions options;
        return make_envelope(model.surfaces, options);
    }();
    EXPECT_NE(envelope.tiles[0].grain.source, "grain line");
    EXPECT_EQ(envelope.tiles[1].grain.source, "grain line");
    EXPECT_NEAR((envelope.tiles[1].grain.direction - Vec3(1, 1, 0).normalized()).norm(), 0, 1e-12);
}

TEST(GrainLine, MayBeStraightOverABulgingTile) {
    CadModel model;
    model.surfaces.push_back({"octant", testing::octant(16)});
    // A chord of 0.2 rad of the unit sphere is 5 mm off it in the middle, a fortieth of its length.
    const auto at = [](double angle) { return Vec3(std::cos(angle) * 0.8, std::cos(angle) * 0.6, std::sin(angle)); };
    model.curves.push_back(on_layer("WARP", at(0.4), at(0.6)));
    EXPECT_TRUE(lay_grain_lines(model).empty());
    EXPECT_EQ(model.surfaces[0].attributes.count("warp"), 1U);
}

TEST(GrainLine, IsNamedWhereItDoesNotHelp) {
    CadModel model = two_sheets();
    model.curves.push_back(on_layer("GRAIN", {0.25, 0.25, 0}, {0.75, 0.25, 0}));
    model.curves.push_back(on_layer("GRAIN", {0.2, 0.4, 0}, {0.2, 0.8, 0}));
    model.curves.push_back(on_layer("GRAIN", {0.2, 0.4, 0.5}, {0.4, 0.4, 0.5}));
    model.curves.push_back(on_layer("GRAIN", {1, 0.5, 0}, {1, 0.5, 0}));
    model.curves.push_back(on_layer("artwork", {9, 9, 9}, {9, 9, 8}));
    const std::vector<std::string> remarks = lay_grain_lines(model);
    ASSERT_EQ(remarks.size(), 3U);
    EXPECT_THAT(remarks[0], HasSubstr("tile left already has a grain line"));
    EXPECT_THAT(remarks[1], HasSubstr("lies on no tile"));
    EXPECT_THAT(remarks[2], HasSubstr("ends where it starts"));
    EXPECT_EQ(model.surfaces[0].attributes.at("warp").substr(0, 3), "0.5") << "the first is kept";
}

TEST(TakeWarp, ReadsThreeNumbersAndRefusesAnythingElse) {
    NamedMesh surface{"G01", testing::rectangle(1, 1, 2, 2)};
    for (const char* good : {"0, 0, 1", "0 0 1", "0;0;1", " 0,0,1 "}) {
        TileOptions options;
        surface.attributes["warp"] = good;
        take_warp(surface, options);
        EXPECT_EQ(*options.warp, Vec3(0, 0, 1)) << good;
        EXPECT_EQ(options.warp_source, "attribute warp");
    }
    for (const char* bad : {"", "up", "1, 2", "1, 2, 3, 4", "0, 0, 0", "nan, 0, 1", "1, 2, x"}) {
        TileOptions options;
        surface.attributes["warp"] = bad;
        try {
            take_warp(surface, options);
            FAIL() << "accepted " << bad;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("tile G01: its attribute warp"));
        }
    }
}

TEST(TakeWarp, TakesAFieldTriangleByTriangle) {
    NamedMesh surface{"G01", testing::rectangle(1, 1, 2, 2)};
    surface.warp.resize(surface.mesh.triangle_count(), 3);
    for (int t = 0; t < surface.mesh.triangle_count(); ++t) surface.warp.row(t) << 1, 0.1 * (t % 2 ? 1 : -1), 0;
    const Envelope envelope = make_envelope({surface}, {});
    const Tile& tile = envelope.tiles[0];
    EXPECT_NEAR((tile.grain.direction - Vec3::UnitX()).norm(), 0, 1e-12) << "the mean of the field";
    const Eigen::Matrix2Xd warp = warp_in_triangles(tile);
    for (int t = 0; t < tile.mesh.triangle_count(); ++t) {
        const Vec3 e1 = (tile.mesh.corner(t, 1) - tile.mesh.corner(t, 0)).normalized();
        EXPECT_NEAR(warp(0, t), surface.warp.row(t).normalized().dot(e1), 1e-12) << "each its own";
    }
    surface.warp.bottomRows(surface.warp.rows() / 2) *= -1;
    EXPECT_THROW(make_envelope({surface}, {}), InputError) << "half of it points the other way";
}

}  // namespace grain_lines_test
}  // namespace ripstop
