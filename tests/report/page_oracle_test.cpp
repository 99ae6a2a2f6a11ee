/// What the PNG pictures share with report.html is said twice, in C++ and in JavaScript: both must say the same.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "ripstop/report/json/report_json.h"
#include "ripstop/report/view/page_colours.h"
#include "ripstop/report/view/page_maps.h"
#include "ripstop/report/words/page_words.h"
#include "support/flat_tiles.h"
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
    json input = {{"report", json::parse(report_json(plan, true))}, {"shares", shares}};
    for (const FlatTile& tile : plan.tiles) {
        const Tolerances limits = plan.tolerances_of(tile.tile);
        input["limits"].push_back({{"strain", limits.strain}, {"shear", limits.shear}});
        const Eigen::VectorXd& tension = tile.flattening.seam_tension;
        input["tension"].push_back(std::vector<double>(tension.begin(), tension.end()));
    }
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("plan.json"), input.dump());
    const std::string source = RIPSTOP_SOURCE_DIR;
    const auto run = testing::run_command("node " + source + "/tests/report/page_oracle.mjs " + source +
                                          "/apps/report/src " + scratch.path("plan.json"));
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
    for (std::size_t place = 0; place < page_places::count; ++place)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(page_colours()[place] >> (16 - 8 * k) & 0xff, said["colours"][4 * place + k]) << place;
    for (std::size_t i = 0; i < shares.size(); ++i) EXPECT_EQ(page_place(shares[i]), said["places"][i]) << shares[i];
}

TEST(ThePageAndThePictures, WriteFiguresAlike) {
    RIPSTOP_REQUIRE_PAGE(said, testing::two_tile_plan());
    for (std::size_t i = 0; i < shares.size(); ++i) {
        EXPECT_EQ(page_figure(shares[i], 2, true), said["figures"][i][0]);
        EXPECT_EQ(short_figure(1000 * shares[i]), said["figures"][i][1]);
    }
}

TEST(ThePageAndThePictures, HaveTheSameMapsAndLegends) {
    for (const CutPlan& plan : {testing::two_tile_plan(), plan_of_two_fabrics()}) {
        RIPSTOP_REQUIRE_PAGE(said, plan);
        ASSERT_EQ(page_maps().size(), said["maps"].size());
        for (std::size_t i = 0; i < page_maps().size(); ++i) {
            const PageMap& map = page_maps()[i];
            const json& page = said["maps"][i];
            EXPECT_EQ(map.id, page["id"]);
            EXPECT_EQ(json::array({map.name, map.negative, map.positive}), page["words"]);
            EXPECT_EQ(json::array({map.is_of_cloth, map.is_of_edges, map.is_unsigned}), page["kinds"]) << map.id;
            const PageLegend legend = page_legend(plan, map);
            if (map.id == "tension" && plan.tiles.back().flattening.seam_tension.size() == 0)
                continue;  // nothing to show
            EXPECT_EQ(json::array({legend.low, legend.high, legend.note}), page["legend"]) << map.id;
            EXPECT_EQ(legend.is_pinned, page["pinned"]) << map.id;
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
