#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "ripstop/flatten/method.h"
#include "support/program.h"
#include "support/sanitized.h"

namespace ripstop {
namespace compare_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ProgramRun;
using ::testing::StartsWith;
using testing::Workshop;

TEST(CompareCommand, HasARowForEveryMethodAndEndsWith0ThoughSomeFail) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    workshop.write_tiles("tile.obj", {testing::curved_tile()});
    const ProgramRun run = workshop.ripstop("compare tile.obj --unit m");
    EXPECT_EQ(run.code, 0) << run.err;
    for (const Method& method : methods()) EXPECT_THAT(run.out, HasSubstr(std::string("sphere  ").append(method.name)));
    EXPECT_EQ(std::count(run.out.begin(), run.out.end(), '\n'), static_cast<long>(methods().size()) + 1);
    EXPECT_THAT(run.out, HasSubstr("no: area, warp_strain, weft_strain"));
}

TEST(CompareCommand, SaysInJsonWhatTheReportOfEachMethodSays) {
    const Workshop workshop;
    workshop.write_tiles("tiles.obj", {testing::bent_tile("a"), testing::curved_tile("b")});
    const ProgramRun run = workshop.ripstop("compare tiles.obj --unit m --method arap --method seam-exact --json");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto compared = nlohmann::json::parse(run.out);
    ASSERT_EQ(compared["tiles"].size(), 2U);
    for (const char* const method : {"arap", "seam-exact"}) {
        workshop.ripstop(std::string("flatten tiles.obj --unit m --quiet --method ") + method + " -o " + method);
        const auto report = nlohmann::json::parse(workshop.read(std::string(method) + "/report.json"));
        for (std::size_t t = 0; t < 2; ++t) {
            EXPECT_EQ(compared["tiles"][t]["name"], report["tiles"][t]["name"]);
            const auto& own = compared["tiles"][t]["methods"][method == std::string("arap") ? 0 : 1];
            for (const char* const key : {"method", "area_error_pct", "boundary_error_max_pct", "energy_j", "verdict"})
                EXPECT_EQ(own[key], report["tiles"][t][key]) << method << " " << key;
        }
    }
}

TEST(CompareCommand, DrawsASheetThatAnIndependentRendererOpens) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const Workshop workshop;
    workshop.write_tiles("tiles.obj", {testing::bent_tile("a"), testing::curved_tile("b <&>")});
    const ProgramRun run = workshop.ripstop("compare tiles.obj --unit m --sheet sheet.svg");
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string sheet = workshop.read("sheet.svg");
    EXPECT_THAT(sheet, HasSubstr("b &lt;&amp;&gt;"));
    if (testing::run_command("rsvg-convert --version").code != 0) GTEST_SKIP() << "no rsvg-convert";
    const auto drawn =
        testing::run_command("rsvg-convert " + workshop.path("sheet.svg") + " -o " + workshop.path("sheet.png"));
    EXPECT_EQ(drawn.code, 0) << drawn.output;
}

TEST(CompareCommand, KeepsASheetThatExistsUnlessForced) {
    const Workshop workshop;
    workshop.write_tiles("tile.obj", {testing::flat_tile()});
    workshop.write("sheet.svg", "mine");
    const ProgramRun refused = workshop.ripstop("compare tile.obj --unit m --method lscm --sheet sheet.svg");
    EXPECT_EQ(refused.code, 3);
    EXPECT_THAT(refused.err, HasSubstr("sheet.svg: exists; give another name, or --force to replace it"));
    EXPECT_EQ(workshop.read("sheet.svg"), "mine");
    EXPECT_EQ(workshop.ripstop("compare tile.obj --unit m --method lscm --sheet sheet.svg --force").code, 0);
    EXPECT_THAT(workshop.read("sheet.svg"), StartsWith("<svg"));
}

TEST(CompareCommand, NeverWritesOverItsInputOrIntoAFolderThatIsNotThere) {
    const Workshop workshop;
    workshop.write_tiles("tile.obj", {testing::flat_tile()});
    const std::string before = workshop.read("tile.obj");
    const ProgramRun over = workshop.ripstop("compare tile.obj --unit m --method lscm --sheet ./tile.obj --force");
    EXPECT_EQ(over.code, 3);
    EXPECT_THAT(over.err, HasSubstr("is the input itself"));
    EXPECT_EQ(workshop.read("tile.obj"), before);
    const ProgramRun nowhere = workshop.ripstop("compare tile.obj --unit m --method lscm --sheet there/sheet.svg");
    EXPECT_EQ(nowhere.code, 3);
    EXPECT_THAT(nowhere.out, IsEmpty());
}

TEST(CompareCommand, RefusesAMethodNobodyKnowsAsUsage) {
    const Workshop workshop;
    workshop.write_tiles("tile.obj", {testing::flat_tile()});
    const ProgramRun run = workshop.ripstop("compare tile.obj --method magic");
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("no method \"magic\""));
    EXPECT_THAT(run.out, IsEmpty());
}

}  // namespace compare_test
}  // namespace ripstop
