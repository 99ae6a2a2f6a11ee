#include "ripstop/report/picture/png_pictures.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <limits>
#include <map>

#include "ripstop/base/error.h"
#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/strain_maps.h"
#include "ripstop/report/picture/piece_png.h"
#include "ripstop/report/view/envelope_view.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/view/piece_view.h"
#include "support/flat_tiles.h"
#include "support/inflated.h"
#include "support/outside.h"
#include "support/raster.h"
#include "support/sanitized.h"
#include "support/seams.h"

namespace ripstop {
namespace png_pictures_test {

using ::testing::ElementsAre;
using ::testing::IsSupersetOf;
using testing::Raster;

using Pictures = std::map<std::string, std::string>;  // bytes by name

Pictures pictures_of(const CutPlan& plan, const std::vector<StrainMap>& strains, int threads = 0) {
    const testing::ScratchDirectory scratch(std::to_string(threads));
    write_png_pictures(scratch.path(), plan, make_pieces(plan), strains, threads);
    Pictures pictures;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path()))
        pictures[entry.path().filename().string()] = testing::content(entry.path().string());
    return pictures;
}

Pictures pictures_of(const CutPlan& plan) {
    return pictures_of(plan, measure_strain_maps(plan));
}

std::vector<std::string> names(const Pictures& pictures) {
    std::vector<std::string> result;
    for (const auto& [name, bytes] : pictures) result.push_back(name);
    return result;
}

/// An upright sheet of 2 m x 2 m that faces the front, with a uniform strain along the warp.
CutPlan standing_sheet() {
    Points2 corners(4, 2);
    corners << 0, 0, 2, 0, 2, 2, 0, 2;
    FlatTile tile = testing::flat_polygon("sheet", corners);
    TriangleMesh& mesh = tile.tile.mesh;
    mesh.positions.col(2) = mesh.positions.col(1).eval();
    mesh.positions.col(1).setZero();
    CutPlan plan;
    plan.tiles = {tile};
    return plan;
}

std::vector<StrainMap> strain_of(double warp, Eigen::Index triangles = 2) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(triangles);
    return {{Eigen::VectorXd::Constant(triangles, warp), none, none, none}};
}

bool is_about(const std::array<int, 3>& colour, int red, int green, int blue) {
    return std::abs(colour[0] - red) < 4 && std::abs(colour[1] - green) < 4 && std::abs(colour[2] - blue) < 4;
}

/// The number of pixels of about this colour in a part of a picture.
int count(const Raster& raster, std::array<int, 3> colour, int left, int top, int right, int bottom) {
    int found = 0;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) found += is_about(raster.at(x, y), colour[0], colour[1], colour[2]);
    return found;
}

TEST(PngPictures, AreThoseOfThePagesViews) {
    EXPECT_THAT(names(pictures_of(testing::two_tile_plan())),
                ElementsAre("Bily__dracek_.png", "G01_P01.png", "envelope-area.png", "envelope-edges.png",
                            "envelope-shear.png", "envelope-warp.png", "envelope-weft.png", "envelope.png"));
    EXPECT_THAT(names(pictures_of(testing::sewn_plan())),
                IsSupersetOf({"envelope-mismatch.png", "seams.png", "seam-S2.png", "left.png"}));
    EXPECT_EQ(pictures_of(testing::sewn_plan()).count("seam-S1.png"), 0u) << "it fits";
}

TEST(PngPictures, HaveTheSameBytesOnAnyNumberOfThreads) {
    const CutPlan plan = testing::two_tile_plan();
    EXPECT_EQ(pictures_of(plan, measure_strain_maps(plan), 1), pictures_of(plan, measure_strain_maps(plan), 3));
}

TEST(PngPictures, OfTheEnvelopeOpenWithTheMapThePageOpensWith) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Pictures poor = pictures_of(testing::two_tile_plan());
    EXPECT_EQ(poor.at("envelope.png"), poor.at("envelope-warp.png"));
    const Pictures sewn = pictures_of(testing::sewn_plan());
    EXPECT_EQ(sewn.at("envelope.png"), sewn.at("envelope-mismatch.png")) << "only seams fail";
    CutPlan good = testing::inflated_plan();
    for (SeamWalk& walk : good.walks) walk.ok = true;
    for (FlatTile& tile : good.tiles) tile.verdict.judged = true;
    const Pictures flying = pictures_of(good);
    EXPECT_EQ(flying.at("envelope.png"), flying.at("envelope-deviation.png")) << "it can be made, and was inflated";
}

TEST(PngPictures, ShowTheClothInTheColourOfItsStrain) {
    RIPSTOP_TOO_LONG_SANITIZED();
    // Both views have their middles, and cloth there, at 400 and 1200. The stops of the legend are at -1, -1/2, 0,
    // 1/2 and 1 of the end of the scale, which is the largest value, rounded up, or the limit of 2 % if that is
    // exceeded.
    for (const auto& [strain, red, green, blue] : {std::tuple{0.0, 0xf7, 0xf5, 0xef},
                                                   {1e-6, 0xf7, 0xf5, 0xee},
                                                   {0.005, 0xe0, 0x6c, 0x00},
                                                   {0.01, 0xe0, 0x6c, 0x00},
                                                   {0.02, 0xe0, 0x6c, 0x00},
                                                   {-0.01, 0x1f, 0x5f, 0xbf},
                                                   {0.021, 0x5c, 0x0a, 0x1e},
                                                   {-0.5, 0x10, 0x1c, 0x4a},
                                                   {std::nan(""), 0, 0, 0}}) {
        const Raster picture = testing::read_png(pictures_of(standing_sheet(), strain_of(strain)).at("envelope.png"));
        ASSERT_EQ(picture.width, 1600);
        for (const int x : {400, 1200})
            EXPECT_TRUE(is_about(picture.at(x, 460), red, green, blue))
                << strain << " at " << x << ": " << ::testing::PrintToString(picture.at(x, 460));
    }
}

TEST(PngPictures, OutlineWhatFailsInRedAndNothingElse) {
    const auto red_in_views = [](const CutPlan& plan) {
        const Raster picture = testing::read_png(pictures_of(plan, strain_of(0)).at("envelope.png"));
        return count(picture, {0xa5, 0x0f, 0x2d}, 0, 180, 1600, picture.height - 110);
    };
    CutPlan plan = standing_sheet();
    EXPECT_EQ(red_in_views(plan), 0);
    plan.tiles[0].verdict.findings = {{"area", "too large", Vec3(1, 0, 1), 3, 1}};
    EXPECT_GT(red_in_views(plan), 4000) << "four sides of some 600 pixels in two views, 2.5 wide and half of it pure";
    CutPlan sewn = testing::sewn_plan();
    const std::vector<StrainMap> strains = measure_strain_maps(sewn);
    const Raster picture = testing::read_png(pictures_of(sewn, strains).at("envelope-warp.png"));
    EXPECT_GT(count(picture, {0xa5, 0x0f, 0x2d}, 0, 180, 1600, picture.height - 110), 50) << "the seam that fails";
}

TEST(PngPictures, KeepWithinThePageHoweverLongTheNames) {
    CutPlan plan = testing::sewn_plan();
    for (FlatTile& tile : plan.tiles) {
        for (int i = 0; i < 30; ++i) tile.tile.name += " Bílý dráček 飛行船 & <WWWW>";
        tile.verdict.findings = {{"area", "area of " + tile.tile.name, Vec3::Zero(), 2, 1}};
    }
    plan.input_file = plan.tiles[0].tile.name;
    const Pictures pictures = pictures_of(plan);
    EXPECT_EQ(pictures.size(), 12u);
    for (const auto& [name, bytes] : pictures) {
        if (name == "seams.png") continue;  // made by seam_picture, whose head is one line
        const Raster picture = testing::read_png(bytes);
        ASSERT_GT(picture.width, 0) << name;
        // The colour of the strip at the top shows the verdict.
        const int clear = count(picture, {255, 255, 255}, 0, 7, 12, picture.height) +
                          count(picture, {255, 255, 255}, picture.width - 12, 7, picture.width, picture.height);
        EXPECT_EQ(clear, 24 * (picture.height - 7)) << name;
    }
}

TEST(PngPictures, OfEqualTilesAreOne) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles.push_back(plan.tiles[1]);
    plan.tiles[2].tile.name = "G02";
    plan.tiles[2].equal_to = 1;
    EXPECT_EQ(pictures_of(plan).count("G02.png"), 0u);
    plan.tiles[2].verdict.findings.clear();
    EXPECT_EQ(pictures_of(plan).count("G02.png"), 1u) << "judged otherwise";
}

TEST(PngPictures, NeverWriteATileOverAnother) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].tile.name = "Envelope";
    plan.tiles[1].tile.name = "tile-envelope";
    EXPECT_THAT(names(pictures_of(plan)),
                IsSupersetOf({"tile-Envelope.png", "tile-tile-envelope.png", "envelope.png"}));
}

TEST(PngPictures, OfATileWithoutFlatPositionsSaySo) {
    CutPlan plan = testing::two_tile_plan();
    for (FlatTile& tile : plan.tiles) {
        tile.flattening = {};
        tile.verdict = {};
    }
    const Pictures pictures = pictures_of(plan);
    EXPECT_THAT(names(pictures), ElementsAre("Bily__dracek_.png", "G01_P01.png", "envelope-edges.png", "envelope.png"));
    EXPECT_GT(testing::read_png(pictures.at("G01_P01.png")).width, 0);
}

TEST(PngPictures, OfSeamsAreTheWorst) {
    CutPlan plan = testing::sewn_plan();
    EXPECT_THAT(pictured_seams(plan), ElementsAre(1u));
    for (int i = 0; i < 30; ++i) {
        plan.walks.push_back(plan.walks[1]);
        plan.walks.back().drift_max *= 1 + 0.1 * i;
    }
    const std::vector<std::size_t> seams = pictured_seams(plan);
    ASSERT_EQ(seams.size(), most_seam_pictures);
    EXPECT_EQ(seams.front(), plan.walks.size() - 1);
    EXPECT_EQ(seams.back(), plan.walks.size() - most_seam_pictures);
}

TEST(PngPictures, OfAPieceHaveEachPlaceInTheColourOfItsTriangle) {
    const CutPlan plan = testing::two_tile_plan();
    const std::vector<PatternPiece> pieces = make_pieces(plan);
    const std::vector<StrainMap> strains = measure_strain_maps(plan);
    const FlatTile& tile = plan.tiles[1];
    const MapView map = map_view(plan, strains, page_map("warp"));
    const double end = map.scales.front().cloth[1];
    const PieceView view = piece_view({plan, 1, &pieces[1], map}, {28, 100}, {972, 660});
    ASSERT_EQ(view.pixels.size(), 1u);
    const PlacedPixels& placed = view.pixels[0];
    for (int t = 0; t < tile.tile.mesh.triangle_count(); ++t) {
        Vec2 middle = Vec2::Zero();
        for (int k = 0; k < 3; ++k) middle += Vec2(tile.flattening.positions.row(tile.tile.mesh.triangles(t, k))) / 3;
        const Vec2 at = placed.per_unit * (view.to_page.at(middle) - placed.at);
        const auto place = static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(placed.pixels.width) +
                           static_cast<std::size_t>(at.x());
        EXPECT_EQ(placed.pixels.colours.at(place),
                  page_colours()[page_place(strains[1].warp[t] / end, map.scales.front().has_beyond)])
            << t;
    }
}

TEST(PngPictures, OfAPieceShowTheMapOfWhatIsWrong) {
    CutPlan plan;
    plan.tiles = {testing::flat_cylinder("G01")};
    const std::vector<const PatternPiece*> pieces{nullptr};
    const auto telling = [&](const std::vector<StrainMap>& strains) {
        const std::vector<MapView> maps = map_views(plan, strains);
        return telling_map({plan, pieces, maps}, 0).map->id;
    };
    EXPECT_EQ(telling(measure_strain_maps(plan)), "warp");
    EXPECT_EQ(telling({}), "edges");
    plan.tiles[0].verdict.findings = {{"outline", "", Vec3::Zero(), 0, 0}, {"weft_strain", "", Vec3::Zero(), 3, 2}};
    EXPECT_EQ(telling(measure_strain_maps(plan)), "weft");
    EXPECT_EQ(telling({}), "edges") << "nothing is known of the weft";
}

TEST(EnvelopeView, ShowsWhatIsNearestAndHidesTheLinesBehindIt) {
    // Two sheets, the smaller one behind the other; it fails.
    CutPlan plan = standing_sheet();
    plan.tiles.push_back(plan.tiles[0]);
    plan.tiles[1].tile.mesh.positions.col(1).array() += 1;
    plan.tiles[1].tile.mesh.positions.array() *= 0.5;
    plan.tiles[1].tile.mesh.positions.col(0).array() += 0.5;
    plan.tiles[1].tile.mesh.positions.col(2).array() += 0.5;
    plan.tiles[1].verdict.findings = {{"area", "too large", Vec3::Zero(), 3, 1}};
    const EnvelopeShape shape = envelope_shape(plan);
    for (const bool is_back : {false, true}) {
        EnvelopeView view = aimed_view(shape, Vec3(0, 0, is_back ? -1 : 1), 200);
        paint_envelope(view, plan, shape, 1);
        const Vec3 middle = view.at(shape.positions[1].colwise().mean().transpose());
        const auto place = static_cast<std::size_t>(middle.y()) * 200 + static_cast<std::size_t>(middle.x());
        EXPECT_EQ(view.cloth[place] >= 2, is_back);
        int red = 0;
        for (const std::uint32_t colour : view.lines) red += colour == 0xa50f2d;
        if (is_back)
            EXPECT_GT(red, 200);
        else
            EXPECT_EQ(red, 0);
    }
}

TEST(EnvelopeView, IsToScale) {
    const EnvelopeShape shape = envelope_shape(standing_sheet());
    const EnvelopeView view = aimed_view(shape, Vec3(0, 0, 1), 1000);
    EXPECT_NEAR(view.pixels_per_metre, 0.97 * 1000 / 2, 1e-9);
    const Vec3 left = view.at({0, 0, 0}), right = view.at({2, 0, 0}), up = view.at({0, 2, 0});
    EXPECT_NEAR(right.x() - left.x(), 970, 1e-9);
    EXPECT_NEAR(left.y() - up.y(), 970, 1e-9) << "y down";
}

}  // namespace png_pictures_test
}  // namespace ripstop
