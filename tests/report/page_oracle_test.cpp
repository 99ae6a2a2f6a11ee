/// The page paints what the program decided: its colours and words must match the PNG pictures.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "ripstop/pattern/piece/pieces.h"
#include "ripstop/pipeline/flatten/strain_maps.h"
#include "ripstop/report/json/report_json.h"
#include "ripstop/report/page/page_shapes.h"
#include "ripstop/report/view/map_view.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/words/page_words.h"
#include "support/flat_tiles.h"
#include "support/inflated.h"
#include "support/outside.h"
#include "support/seams.h"

namespace ripstop {
namespace page_oracle_test {

using nlohmann::json;

const std::vector<double> shares{-2.0, -1.0001, -1.0, -0.999, -0.5,  -1e-9,   0.0,       0.003,       0.25,
                                 0.5,  0.7512,  0.99, 1.0,    1.001, 12.3456, 12345.678, std::nan("")};

/// What the page says about a plan; null without Node.js.
json page_says(const CutPlan& plan) {
    if (testing::run_command("node --version").code != 0) return {};
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("report.json"), report_json(plan, true));
    testing::write_text(scratch.path("shapes"), page_shapes(plan, make_pieces(plan), measure_strain_maps(plan)));
    testing::write_text(scratch.path("shares.json"), json(shares).dump());
    const std::string source = RIPSTOP_SOURCE_DIR;
    const auto run = testing::run_command("node " + source + "/tests/report/page_oracle.mjs " + source +
                                          "/apps/report/src " + scratch.path("report.json") + " " +
                                          scratch.path("shapes") + " " + scratch.path("shares.json"));
    EXPECT_EQ(run.code, 0) << run.output;
    return run.code == 0 ? json::parse(run.output) : json();
}

#define RIPSTOP_REQUIRE_PAGE(said, plan) \
    const json said = page_says(plan);   \
    if (said.is_null()) GTEST_SKIP() << "no Node.js here"

CutPlan plan_of_two_fabrics() {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].tile.fabric = Fabric{};
    plan.tiles[0].tile.fabric->strain_limit = 0.035;
    plan.tiles[0].tile.fabric->shear_limit = 0.2;
    plan.tiles[1].flattening.seam_tension =
        Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(plan.tiles[1].tile.boundary.size()), -137.5, 20);
    FlatTile more = plan.tiles[1];
    more.tile.name = "G02";
    more.verdict.findings.push_back({"warp_strain", "too much", Vec3::Zero(), -12.27, 2});
    more.verdict.findings.push_back({"flipped", "turned over", Vec3::Zero(), 3, 0});
    more.proposal = SplitProposal{"across the warp", {Vec3::Zero(), Vec3::UnitX()}, {}, 4, 3};
    plan.tiles.push_back(more);
    return plan;
}

TEST(ThePageAndThePictures, HaveTheSameColours) {
    RIPSTOP_REQUIRE_PAGE(said, testing::two_tile_plan());
    ASSERT_EQ(said["colours"].size(), page_palettes().size());
    for (std::size_t palette = 0; palette < page_palettes().size(); ++palette)
        for (std::size_t place = 0; place < page_places::count; ++place)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(page_palettes()[palette].colours[place] >> (16 - 8 * k) & 0xff,
                          said["colours"][palette][4 * place + k])
                    << palette << " " << place;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        EXPECT_EQ(page_place(shares[i]), said["places"][0][i]) << shares[i];
        EXPECT_EQ(page_place(shares[i], false), said["places"][1][i]) << shares[i];
    }
}

TEST(ThePageAndThePictures, WriteFiguresAlike) {
    RIPSTOP_REQUIRE_PAGE(said, testing::two_tile_plan());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        EXPECT_EQ(page_figure(shares[i], 2, true), said["figures"][i][0]);
        EXPECT_EQ(short_figure(1000 * shares[i]), said["figures"][i][1]);
    }
}

/// Expects values within one step of the palette, because values are rounded for the page.
void expect_same_places(const std::vector<std::uint16_t>& picture, const json& page, const std::string& what) {
    ASSERT_EQ(picture.size(), page.size()) << what;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const int place = picture[i], other = page[i].get<int>();
        EXPECT_LE(std::abs(place - other), place > page_places::above || other > page_places::above ? 0 : 1)
            << what << ", number " << i;
    }
}

void expect_same_view(const CutPlan& plan, const MapView& view, std::size_t scale, const json& page) {
    const std::string what = std::string(view.map->id) + " " + std::string(view.scales[scale].id) + ", tile ";
    for (std::size_t i = 0; i < plan.tiles.size(); ++i) {
        expect_same_places(cloth_places(plan, view, i, scale), page["cloth"][i], what + std::to_string(i));
        expect_same_places(edge_places(view, i, scale), page["edges"][i], what + std::to_string(i) + ", edges");
    }
    EXPECT_EQ(page["note"], view.scales[scale].note);
    for (const std::string& end : {view.scales[scale].low, view.scales[scale].middle, view.scales[scale].high})
        if (!end.empty()) {
            EXPECT_THAT(page["legend"], ::testing::Contains(end)) << what;
        }
    const auto beyond = ::testing::Contains("beyond");
    if (view.scales[scale].has_beyond)
        EXPECT_THAT(page["legend"], beyond) << what;
    else
        EXPECT_THAT(page["legend"], ::testing::Not(beyond)) << what;
}

TEST(ThePageAndThePictures, PaintTheSameInEveryMapAndScale) {
    for (const CutPlan& plan : {testing::two_tile_plan(), plan_of_two_fabrics(), testing::sewn_plan(),
                                testing::unevenly_meshed_plan(), testing::inflated_plan()}) {
        RIPSTOP_REQUIRE_PAGE(said, plan);
        const std::vector<StrainMap> strains = measure_strain_maps(plan);
        const std::vector<MapView> views = map_views(plan, strains);
        EXPECT_EQ(said["first"]["map"], first_map(plan, strains));
        ASSERT_EQ(views.size(), said["maps"].size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            const json& page = said["maps"][i];
            EXPECT_EQ(page["id"], views[i].map->id);
            EXPECT_EQ(page["name"], views[i].map->name);
            expect_same_view(plan, views[i], 0, page["first"]);
            ASSERT_EQ(page["scales"].size(), views[i].scales.size());
            for (std::size_t scale = 0; scale < views[i].scales.size(); ++scale)
                expect_same_view(plan, views[i], scale, page["scales"][scale]);
        }
    }
}

TEST(ThePageAndThePictures, SayTheVerdictInTheSameWords) {
    CutPlan good = testing::two_tile_plan(), seams = testing::sewn_plan(), faulty = good, one = good;
    good.tiles[1].verdict.findings.clear();
    seams.findings.push_back({"seam", "seam S2: the edge is too long", Vec3::Zero(), 2, 1});
    faulty.tiles[1].verdict.findings.clear();
    faulty.findings.push_back({"missing_tile", "a tile may be missing", Vec3::Zero(), 0, 0});
    one.tiles.pop_back();
    for (const CutPlan& plan : {good, seams, faulty, one, plan_of_two_fabrics()}) {
        RIPSTOP_REQUIRE_PAGE(said, plan);
        const PageWords words = page_words(plan);
        EXPECT_EQ(words.word + " " + words.headline, said["headline"]);
        EXPECT_EQ(json(plain(words.why)), said["why"]);
        EXPECT_EQ(json(plain(words.redesign)), said["redesign"]);
    }
}

}  // namespace page_oracle_test
}  // namespace ripstop
