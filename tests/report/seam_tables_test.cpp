#include "ripstop/report/tables/seam_tables.h"

#include <gmock/gmock.h>

#include <limits>

#include "ripstop/report/picture/seam_picture.h"
#include "ripstop/report/tables/tables.h"
#include "support/flat_tiles.h"
#include "support/outside.h"
#include "support/seams.h"

namespace ripstop {
namespace seam_tables_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(SeamsCsv, HasALineASeam) {
    CutPlan plan = testing::sewn_plan();
    plan.seams[1].type = {"plain", 0.013, 1, false};
    const std::string text = seams_csv(plan);
    EXPECT_THAT(text,
                HasSubstr("id,tile_a,chain_a,tile_b,chain_b,length_mm,flat_a_mm,flat_b_mm,mismatch_mm,mismatch_pct,"
                          "drift_max_mm,drift_max_at_mm,limit_mm,uncertainty_mm,gap_mm,certain,ok,type,"
                          "allowance_a_mm,allowance_b_mm,sewn_into\n"));
    EXPECT_THAT(text, HasSubstr("\nS2,left,2,high,4,1000,1000,1002,2,0.2,2,1000,1,0,0,true,false,plain,13,13,\n"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
}

TEST(SeamsCsv, LeavesEmptyWhatIsNotFinite) {
    CutPlan plan = testing::sewn_plan();
    plan.walks[0].flat_a = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(seams_csv(plan), HasSubstr("S1,left,2,low,4,1000,,1000,,,"));
}

TEST(SeamsSummary, CountsTheSeamsAndNamesTheWorst) {
    const std::string text = seams_summary(testing::sewn_plan());
    EXPECT_THAT(text,
                HasSubstr("2 of 3 seams agree; worst: mismatch +2.000 mm, +0.2000 % (S2), drift 2.000 mm (S2)\n"));
    EXPECT_THAT(text, HasSubstr("  seam S2, 1000 mm long: the edge of high is 2.00 mm longer than the edge of left"));
    EXPECT_THAT(tiles_table(testing::sewn_plan()), HasSubstr("2 of 3 seams agree"));
    EXPECT_THAT(seams_summary(testing::two_tile_plan()), IsEmpty());
    EXPECT_THAT(seams_summary(testing::sewn_plan(), 0), HasSubstr("and 1 more"));
}

TEST(SeamsOfChains, ComeInTheOrderOfTheChain) {
    const CutPlan plan = testing::sewn_plan();
    const auto sewn = seams_of_chains(plan);
    ASSERT_EQ(sewn.size(), 3u);
    EXPECT_THAT(sewn[0], ElementsAre(IsEmpty(), ElementsAre(0, 1), IsEmpty(), IsEmpty()));
    EXPECT_THAT(sewn[2], ElementsAre(ElementsAre(2), IsEmpty(), IsEmpty(), ElementsAre(1)));
}

int count(const std::string& text, const std::string& what) {
    int n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

TEST(SeamPicture, WritesAtEachEdgeHowMuchLongerItIsThanItsMate) {
    const std::string svg = seam_picture(testing::sewn_plan());
    EXPECT_EQ(count(svg, ">+2.00</text>"), 1);
    EXPECT_EQ(count(svg, ">-2.00</text>"), 1);
    EXPECT_EQ(count(svg, ">0.000</text>"), 4);
    EXPECT_THAT(svg, HasSubstr(">some seams do not agree</text>"));
    EXPECT_THAT(svg, HasSubstr(">1 mm</text>")) << "the scale is pinned to the tolerance";
    EXPECT_THAT(svg, HasSubstr("stroke=\"#ce1826\" stroke-width=\"5\"")) << "beyond the tolerance, thick";
    for (const char* name : {">left<", ">low<", ">high<"}) EXPECT_EQ(count(svg, name), 1) << name;
}

TEST(SeamPicture, IsWrittenWithThePlanThatHasSeams) {
    EXPECT_THAT(seam_picture(testing::two_tile_plan()), IsEmpty());
    CutPlan plan = testing::sewn_plan();
    plan.tiles[1].flattening.positions = Points2();
    EXPECT_THAT(seam_picture(plan), Not(HasSubstr(">low<"))) << "what was not flattened is not drawn";
}

}  // namespace seam_tables_test
}  // namespace ripstop
