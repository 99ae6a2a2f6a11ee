#include "ripstop/report/tables/tables.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string_view>

#include "support/flat_tiles.h"

namespace ripstop {
namespace tables_test {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) result.push_back(line);
    return result;
}

/// The fields of a CSV line, by RFC 4180.
std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> result(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"')
            result.back() += line[i++];
        else if (line[i] == '"')
            quoted = !quoted;
        else if (line[i] == ',' && !quoted)
            result.emplace_back();
        else
            result.back() += line[i];
    }
    return result;
}

CutPlan plan_of(int tiles, int failing) {
    CutPlan plan;
    const FlatTile tile = testing::flat_cylinder("");
    const Finding finding{"chain", "too long", Vec3::Zero(), 1, 0.1};
    for (int i = 0; i < tiles; ++i) {
        plan.tiles.push_back(tile);
        plan.tiles.back().tile.name = std::string("T").append(std::to_string(100 + i));
        if (i >= tiles - failing) plan.tiles.back().verdict.findings = {finding};
    }
    return plan;
}

TEST(TilesCsv, HasALineATileAndAFieldAColumn) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[1].verdict.findings[0].message = "chain 1 is too long, by \"a lot\"";
    plan.tiles[1].tile.fabric = Fabric{};
    plan.tiles[1].tile.fabric->name = "silk";
    const auto all = lines(tiles_csv(plan));
    ASSERT_EQ(all.size(), 3u);
    const auto heads = fields(all[0]), first = fields(all[1]), second = fields(all[2]);
    ASSERT_EQ(heads.size(), 30u);
    ASSERT_EQ(first.size(), heads.size());
    ASSERT_EQ(second.size(), heads.size());
    const auto of = [&](const std::vector<std::string>& row, const std::string& column) {
        const auto at = std::find(heads.begin(), heads.end(), column);
        return at == heads.end() ? "no column " + column : row[static_cast<std::size_t>(at - heads.begin())];
    };
    EXPECT_EQ(of(first, "name"), "G01 P01");
    EXPECT_EQ(of(second, "name"), "Bílý \"dráček\"");
    EXPECT_EQ(of(first, "triangles"), "192");
    EXPECT_EQ(of(first, "fabric"), "isotropic");
    EXPECT_EQ(of(second, "fabric"), "silk");
    EXPECT_EQ(of(first, "manufacturable"), "true");
    EXPECT_EQ(of(second, "manufacturable"), "false");
    EXPECT_EQ(of(second, "warp_min_pct"), "-1");
    EXPECT_EQ(of(second, "warp_max_pct"), "0.5");
    EXPECT_EQ(of(second, "shear_max_deg"), "2");
    EXPECT_EQ(of(second, "energy_j"), "1.5");
    EXPECT_EQ(of(second, "stop"), "converged");
    EXPECT_EQ(of(second, "finding"), "chain 1 is too long, by \"a lot\"");
    // Half of the last digit: a millionth of the unit, or the seventh digit.
    EXPECT_NEAR(std::stod(of(first, "area_m2")), plan.tiles[0].accuracy.area, 0.51e-6);
    EXPECT_NEAR(std::stod(of(first, "perimeter_mm")), 1000 * plan.tiles[0].accuracy.perimeter, 0.51e-3);
    EXPECT_NEAR(std::stod(of(second, "chain_error_max_pct")), 100 * plan.tiles[1].accuracy.chains[0].error(), 0.1);
}

TEST(TilesCsv, LeavesEmptyWhatIsNotFinite) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].accuracy.energy = std::numeric_limits<double>::infinity();
    plan.tiles[0].accuracy.chains[0] = {0, 0};
    EXPECT_THAT(tiles_csv(plan), Not(HasSubstr("inf")));
    EXPECT_THAT(tiles_csv(plan), Not(HasSubstr("nan")));
    EXPECT_EQ(fields(lines(tiles_csv(plan))[1])[14], "");
    EXPECT_EQ(fields(lines(tiles_csv(plan))[1])[20], "");
}

TEST(TilesTable, AlignsItsColumnsWhateverTheLetters) {
    const auto all = lines(tiles_table(testing::two_tile_plan()));
    ASSERT_GE(all.size(), 5u);
    const auto letters_before = [](const std::string& line, const std::string& text) {
        const std::string_view before = std::string_view(line).substr(0, line.rfind(text));
        return std::count_if(before.begin(), before.end(), [](char c) { return (c & 0xC0) != 0x80; });
    };
    EXPECT_EQ(letters_before(all[0], "verdict"), letters_before(all[1], "ok"));
    EXPECT_EQ(letters_before(all[0], "verdict"), letters_before(all[2], "no: chain"));
    EXPECT_EQ(all[3], "1 of 2 tiles manufacturable, 1.08 m2 of cloth");
}

TEST(TilesTable, ShortensNamesThatWouldPushTheFiguresOffTheScreen) {
    CutPlan plan = testing::two_tile_plan();
    plan.tiles[0].tile.name = std::string(32, 'x');
    plan.tiles[1].tile.name = std::string(31, 'y').append("ůů").append(300, 'y');
    const auto all = lines(tiles_table(plan));
    EXPECT_THAT(all[1], StartsWith(std::string(32, 'x').append(" ")));
    EXPECT_THAT(all[2], StartsWith(std::string(31, 'y').append("ů… ")));
}

TEST(TilesTable, ShowsAllTilesUpToItsRowsAndThenTheFailingOnes) {
    EXPECT_EQ(lines(tiles_table(plan_of(40, 0))).size(), 41u + 3);
    const std::string many = tiles_table(plan_of(100, 3));
    EXPECT_THAT(many, Not(HasSubstr("T100 ")));
    EXPECT_THAT(many, HasSubstr("T197 "));
    EXPECT_THAT(many, HasSubstr("97 more tiles, 0 of them failing"));
    EXPECT_THAT(many, HasSubstr("97 of 100 tiles manufacturable"));
    const std::string bad = tiles_table(plan_of(100, 60));
    EXPECT_THAT(bad, HasSubstr("T179 "));
    EXPECT_THAT(bad, Not(HasSubstr("T180 ")));
    EXPECT_THAT(bad, HasSubstr("60 more tiles, 20 of them failing"));
}

TEST(PlanSummary, CountsThePatternsThatAreCutMoreThanOnce) {
    EXPECT_THAT(plan_summary(plan_of(6, 0)), Not(HasSubstr("different")));
    CutPlan plan = plan_of(6, 0);
    for (const std::size_t i : {2u, 4u}) plan.tiles[i].equal_to = 0;
    for (const std::size_t i : {3u, 5u}) plan.tiles[i].equal_to = 1;
    EXPECT_THAT(plan_summary(plan), HasSubstr("6 tiles, 2 different, each 3 times\n"));
    plan.tiles[5] = plan_of(1, 0).tiles[0];
    plan.tiles[3].mirrored = true;
    EXPECT_THAT(plan_summary(plan), HasSubstr("6 tiles, 3 different, 1 of them 3 times, 1 of them 2 times, mirror"));
    for (std::size_t i = 1; i < 6; ++i) plan.tiles[i].equal_to = 0;
    plan.tiles[3].mirrored = false;
    EXPECT_THAT(plan_summary(plan), HasSubstr("6 tiles, 1 different, 6 times\n"));
    const auto first = fields(lines(tiles_csv(plan))[1]), second = fields(lines(tiles_csv(plan))[2]);
    EXPECT_EQ(first[27], "6");
    EXPECT_EQ(second[25], "T100");
    EXPECT_EQ(second[27], "0");
}

TEST(PlanSummary, NamesTheWorst) {
    const CutPlan plan = testing::two_tile_plan();
    const std::string text = plan_summary(plan);
    EXPECT_THAT(text, HasSubstr("strain -1.00 % (Bílý \"dráček\")"));
    EXPECT_THAT(text, HasSubstr("shear 2.00 deg"));
    EXPECT_THAT(plan_summary(CutPlan{}), HasSubstr("0 of 0 tiles"));
}

}  // namespace tables_test
}  // namespace ripstop
