/// `ripstop nest` and `ripstop diff` on the command line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "support/program.h"
#include "support/sanitized.h"

namespace ripstop {
namespace nest_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

/// The plan of a small balloon: 24 tiles in 4 patterns.
void make_plan(const Workshop& workshop, const std::string& name, const std::string& options = "") {
    ASSERT_EQ(workshop.ripstop("design natural --gores 6 --panels 4 --volume 20 --edge 300mm -o " + name + ".obj").code,
              0);
    ASSERT_LE(workshop.ripstop("flatten " + name + ".obj --unit m --quiet -o " + name + " " + options).code, 1);
}

TEST(NestCommand, LaysAPlanOnTheRoll) {
    const Workshop workshop;
    make_plan(workshop, "plan");
    const ProgramRun run = workshop.ripstop("nest plan --effort 3");
    EXPECT_EQ(run.code, 0) << run.err << run.out;
    EXPECT_THAT(run.out, HasSubstr("running m"));
    std::vector<std::string> names;
    for (const auto& [name, bytes] : workshop.files("plan/marker")) names.push_back(name);
    EXPECT_THAT(names, ElementsAre("bom.csv", "marker.dxf", "marker.json", "marker.pdf", "marker.svg"));
    EXPECT_THAT(workshop.read("plan/bom.csv"), HasSubstr("cloth,,isotropic,,24,,"));
    const std::string page = workshop.read("plan/report.html");
    EXPECT_EQ(workshop.ripstop("nest plan").code, 3) << "what is there is kept without --force";
    const ProgramRun json = workshop.ripstop("nest plan --effort 3 --json --force");
    EXPECT_EQ(json.code, 0);
    EXPECT_EQ(json.out, workshop.read("plan/marker/marker.json"));
    EXPECT_EQ(workshop.read("plan/report.html"), page) << "the roll is shown in the page, once";
    std::set<std::string> laid;
    const Json marker = Json::parse(json.out)["markers"][0];
    for (const Json& placement : marker["placements"]) laid.insert(placement["piece"].get<std::string>());
    EXPECT_EQ(laid.size(), 24u) << "each with its own name, though they have 4 patterns";
    const ProgramRun one_thread = workshop.ripstop("nest plan --effort 3 --json --jobs 1 -o other");
    EXPECT_EQ(one_thread.out, json.out);
}

TEST(NestCommand, EndsWith1WhereAPieceDoesNotFit) {
    const Workshop workshop;
    make_plan(workshop, "plan");
    const ProgramRun run = workshop.ripstop("nest plan --roll 600mm --effort 0 --quiet");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr(" x G01P"));
    EXPECT_THAT(run.out, HasSubstr("take a wider roll"));
}

TEST(NestCommand, RefusesWhatItCannotUse) {
    const Workshop workshop;
    EXPECT_EQ(workshop.ripstop("nest nowhere").code, 3);
    make_plan(workshop, "plan");
    EXPECT_EQ(workshop.ripstop("nest plan --roll 1500").code, 3) << "a length without a unit";
    EXPECT_EQ(workshop.ripstop("nest plan --grain-tolerance 45").code, 2);
    EXPECT_EQ(workshop.ripstop("nest plan --format paper").code, 2);
    make_plan(workshop, "other");
    const auto before = workshop.files("other");
    for (const char* target : {"other", "other/cut"}) {
        const ProgramRun run = workshop.ripstop(std::string("nest plan --effort 0 --force -o ") + target);
        EXPECT_EQ(run.code, 3) << target;
        EXPECT_THAT(run.err, HasSubstr("give the marker its own folder"));
    }
    EXPECT_EQ(workshop.files("other"), before);
    EXPECT_EQ(workshop.ripstop("nest plan --effort 0 --quiet --formats svg -o svg").code, 0);
}

TEST(DiffCommand, Ends0For1OtherAnd3Unreadable) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    make_plan(workshop, "one");
    make_plan(workshop, "two", "--grain 3");
    const ProgramRun same = workshop.ripstop("diff one one");
    EXPECT_EQ(same.code, 0);
    EXPECT_EQ(same.out, "No piece changed.\n");
    const ProgramRun other = workshop.ripstop("diff one two");
    EXPECT_EQ(other.code, 1);
    EXPECT_THAT(other.out, HasSubstr("G01P02"));
    EXPECT_THAT(other.err, IsEmpty());
    const Json json = Json::parse(workshop.ripstop("diff one two --json").out);
    EXPECT_FALSE(json["same"]);
    const Json& first = json["pieces"][0];
    EXPECT_NEAR(first["grain_turn_deg"], 3, 0.2);  // the cloth bends slightly differently along another warp
    const ProgramRun unreadable = workshop.ripstop("diff one nowhere");
    EXPECT_EQ(unreadable.code, 3);
    EXPECT_THAT(unreadable.err, HasSubstr("flatten the envelope first"));
}

}  // namespace nest_test
}  // namespace ripstop
