#include "ripstop/report/words/inflated_says.h"

#include <gmock/gmock.h>

#include <limits>

#include "ripstop/report/words/inflated_text.h"
#include "support/inflated.h"

namespace ripstop {
namespace inflated_says_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class InflatedSays : public ::testing::Test {
  protected:
    CutPlan plan = testing::inflated_plan();
    Inflated& inflated = *plan.inflated;
    std::vector<std::string> says() const { return inflated_says(plan); }
};

TEST_F(InflatedSays, StatesTheLimitAndWhetherTheShapeIsWithinIt) {
    EXPECT_EQ(says()[0],
              "Inflated, it is everywhere within 0.3 % of its height (30 mm) of the drawn shape: 10 mm off (root "
              "mean square), at most 20 mm inside it.");
    inflated.off.max = 0.040;
    EXPECT_THAT(says()[0], HasSubstr("it is within 0.3 % of its height (30 mm) of the drawn shape overall"));
    EXPECT_THAT(says()[0], HasSubstr("up to 40 mm outside it in places"));
    inflated.off.rms = 0.031;
    EXPECT_THAT(says()[0], HasSubstr("more than 0.3 % of its height (30 mm) off the drawn shape: 31 mm"));
}

TEST_F(InflatedSays, TellsApartWhatGasCannotHoldAndWhatIsWrongWithThePatterns) {
    EXPECT_THAT(says(), Contains(HasSubstr("Gas pressure can hold this shape")));
    EXPECT_THAT(says(), Contains("The patterns are right: their errors move it by 2.0 mm."));
    EXPECT_THAT(says(), Contains("The stretch of cloth and tapes moves it by 8.0 mm."));
    inflated.causes = Causes{0.050, 0.008, 0.002};
    EXPECT_THAT(says(),
                Contains("This shape cannot be held by gas pressure: even if cut without error from cloth that does "
                         "not stretch, it would be 50 mm off."));
    EXPECT_THAT(says(), Contains(HasSubstr("The patterns are right")));
    inflated.causes = Causes{0.001, 0.008, 0.045};
    EXPECT_THAT(says(), Contains(HasSubstr("Gas pressure can hold this shape")));
    EXPECT_THAT(says(), Contains("The patterns are wrong: their errors move it by 45 mm."));
    inflated.causes = Causes{0.001, 0.080, 0.002};
    EXPECT_THAT(
        says(),
        Contains("The stretch of the cloth and the paths of the tapes move it by 80 mm: cut with --compensate."));
}

TEST_F(InflatedSays, DrawsTheLineAtTheLimitItself) {
    inflated.causes = Causes{0.030, 0.030, 0.030};
    EXPECT_THAT(says(), Contains(HasSubstr("Gas pressure can hold this shape")));
    EXPECT_THAT(says(), Contains(HasSubstr("The patterns are right")));
    EXPECT_THAT(says(), Not(Contains(HasSubstr("--compensate"))));
}

TEST_F(InflatedSays, DoesNotAdviseToCorrectWhatWasCorrected) {
    inflated.causes = Causes{0.050, 0.080, std::numeric_limits<double>::quiet_NaN()};
    plan.rounds = {{"as drawn", {0.08, 0.1, 0.090, 0.1}, 10, 400, 0, false},
                   {"elastic", {0.01, 0.02, 0.012, 0.025}, 10, 400, 0, true}};
    EXPECT_THAT(says(), Not(Contains(HasSubstr("--compensate"))));
    EXPECT_THAT(says(), Contains(HasSubstr("As drawn, gas pressure could not hold this shape")));
    EXPECT_THAT(says(), Not(Contains(HasSubstr("The patterns are")))) << "what was wanted of them is not the drawing";
    EXPECT_THAT(says(), Contains(HasSubstr("brought it from 90 mm to 12 mm")));
    inflated.off.moved_rms = 0.060;
    EXPECT_THAT(says(), Contains(HasSubstr("This shape cannot be held by gas pressure"))) << "not even corrected";
    EXPECT_THAT(says(), Contains(HasSubstr("The effect of the patterns is not known")));
}

TEST_F(InflatedSays, SaysNothingOfCausesThatWereNotLookedFor) {
    inflated.causes.reset();
    EXPECT_THAT(says(), Not(Contains(HasSubstr("patterns"))));
    EXPECT_THAT(says(), Not(Contains(HasSubstr("hold"))));
}

TEST_F(InflatedSays, NamesWhatIsTooWeakElseWhatComesNearest) {
    EXPECT_THAT(says(), Contains("Strong enough; smallest margin: wires, factor 7.10, required 2.25 (wire 1)."));
    inflated.safety[1].factor = 4.9;
    EXPECT_THAT(says(), Contains("Too weak: load tapes, factor 4.90, required 5 (seam S1)."));
    EXPECT_THAT(says(), Not(Contains(HasSubstr("Strong enough"))));
}

TEST_F(InflatedSays, TellsTheLiftInKilograms) {
    EXPECT_THAT(says(), Contains("At 100 C inside and 15 C outside, at an altitude of 0 m, it lifts 1000 kg (9807 N) "
                                 "in addition to its own weight."));
    inflated.lift = -98.0665;
    EXPECT_THAT(says(),
                ElementsAre(HasSubstr(
                    "It does not stand: at 100 C inside and 15 C outside, at an altitude of 0 m, the gas does not "
                    "carry it, 10.0 kg are missing.")));
}

TEST_F(InflatedSays, WarnsFirstOfWhatIsNotAtRestStableOrBalanced) {
    inflated.is_stable = false;
    EXPECT_THAT(says()[0], HasSubstr("not stable"));
    inflated.summary.termination = Termination::iteration_limit;
    EXPECT_THAT(says()[0], HasSubstr("did not come to rest (iteration limit"));
    inflated.imbalance = 0.05;
    EXPECT_THAT(says()[1], HasSubstr("differ by 5.0 %"));
}

TEST_F(InflatedSays, SaysOnlyThatItFailedWhereItDid) {
    inflated.summary = {Termination::failed, 3, 0, "the cloth turned inside out"};
    EXPECT_EQ(says(), std::vector<std::string>{"The inflation failed: the cloth turned inside out."});
    EXPECT_EQ(inflated_text(plan), "The inflation failed: the cloth turned inside out.\n");
}

TEST_F(InflatedSays, WarnsOfTheStandInForCloth) {
    plan.fabric.name = "isotropic";
    EXPECT_THAT(says()[0], HasSubstr("No fabric was given"));
}

TEST_F(InflatedSays, TellsEachCompensationOnItsOwn) {
    plan.tiles[0].tile.compensation = {0.02, 0.01, {0.005, 0.005, 0, 0}};
    EXPECT_THAT(says(), Contains("1 of 3 tiles is cut longer for shrinkage along the warp: 2.00 %."));
    EXPECT_THAT(says(), Contains("1 of 3 tiles is cut longer for shrinkage along the weft: 1.00 %."));
    EXPECT_THAT(says(), Contains("1 of 3 tiles is cut longer for take-up of the seams: 0.50 %."));
    plan.tiles[1].tile.compensation.warp = 0.01;
    EXPECT_THAT(says(), Contains("2 of 3 tiles are cut longer for shrinkage along the warp: 1.00 to 2.00 %."));
}

TEST_F(InflatedSays, MentionsWrinklesWhereThereAreSome) {
    EXPECT_THAT(says(), Contains("5.0 % of the cloth is wrinkled, 1.0 % is slack."));
    inflated.wrinkled = inflated.slack = 0.001;
    EXPECT_THAT(says(), Not(Contains(HasSubstr("wrinkled"))));
}

TEST_F(InflatedSays, StandsAboveTheTablesOfTheTerminal) {
    plan.rounds = {{"as drawn", {0.08, -0.1, 0.09, 0.11}, 10.1, 410, 0, false},
                   {"elastic", {0.01, 0.02, 0.012, 0.025}, 10.05, 404, 0, true}};
    inflated.sensitivity = {{"cloth 20 % softer", {0.013, 0.02, 0.014, 0.03}, 10.06, 405}};
    const std::string text = inflated_text(plan);
    EXPECT_EQ(text.find(says()[0]), 0u);
    for (const char* row :
         {"height mm    10000.0   10050.0    +50.0  +0.50 %", "volume m3     400.00    404.00    +4.00  +1.00 %",
          "1 as drawn", "+20.0", "taken", "cloth 20 % softer"})
        EXPECT_THAT(text, HasSubstr(row));
    EXPECT_THAT(text, HasSubstr("shape 1.0 mm, stretch 8.0 mm, patterns 2.0 mm"));
    EXPECT_THAT(text, HasSubstr("ok, seam S1"));
    std::size_t longest = 0;
    for (std::size_t from = text.find("\n\n"), to = 0; from < text.size(); from = to + 1) {
        to = std::min(text.find('\n', from), text.size());
        longest = std::max(longest, to - from);
    }
    EXPECT_LE(longest, 100u) << "the tables fit a terminal";
}

}  // namespace inflated_says_test
}  // namespace ripstop
