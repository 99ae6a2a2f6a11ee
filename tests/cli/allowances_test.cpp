/// The program on pieces whose allowances meet.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "support/flat_tiles.h"
#include "support/program.h"
#include "support/shared_data.h"

namespace ripstop {
namespace allowances_test {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;

/// A square of 0.8 m with a slot, 30 mm wide and 300 mm deep.
NamedMesh slotted() {
    Points2 corners(8, 2);
    corners << 0, 0, 0.8, 0, 0.8, 0.8, 0.415, 0.8, 0.415, 0.5, 0.385, 0.5, 0.385, 0.8, 0, 0.8;
    return {"slotted", testing::flat_polygon("slotted", corners).tile.mesh, {}};
}

nlohmann::json findings_of(const Workshop& workshop, const std::string& plan) {
    return nlohmann::json::parse(workshop.read(plan + "/report.json"))["tiles"][0]["verdict"]["findings"];
}

TEST(Allowances, ThatDoNotFitAreAFindingWithPlaceAndWidthsAndAllFilesAreWritten) {
    const Workshop workshop;
    workshop.write_tiles("slotted.obj", {slotted()});
    const ProgramRun run = workshop.ripstop("flatten slotted.obj --unit m -o plan");
    EXPECT_EQ(run.code, 1) << run.out << run.err;
    const auto findings = findings_of(workshop, "plan");
    ASSERT_EQ(findings.size(), 1U) << findings;
    EXPECT_EQ(findings[0]["code"], "allowances_meet");
    EXPECT_THAT(findings[0]["message"].get<std::string>(), HasSubstr("25 + 25 mm in a gap of 30 mm"));
    EXPECT_NEAR(findings[0]["value"].get<double>(), 30, 1e-3);
    EXPECT_NEAR(findings[0]["limit"].get<double>(), 50, 1e-9);
    EXPECT_NEAR(std::abs(findings[0]["at_mm"][0].get<double>() - 400), 15, 1e-3);
    for (const char* file : {"envelope.dxf", "envelope.svg", "envelope.pdf"})
        EXPECT_FALSE(workshop.read(std::string("plan/cut/") + file).empty()) << file;
    const ProgramRun validated = workshop.ripstop("validate plan/cut/envelope.dxf");
    EXPECT_EQ(validated.code, 0) << validated.out << "the opening is in the file";
}

TEST(Allowances, AreMadeToFitOnRequestWithANote) {
    const Workshop workshop;
    workshop.write_tiles("slotted.obj", {slotted()});
    const ProgramRun run = workshop.ripstop("flatten slotted.obj --unit m --allowance-fit -o plan");
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_THAT(run.err, HasSubstr("Warning: slotted: the allowances of"));
    EXPECT_THAT(run.err, HasSubstr("leaves 14.5 mm"));
    EXPECT_TRUE(findings_of(workshop, "plan").empty());
    const auto report = nlohmann::json::parse(workshop.read("plan/report.json"));
    ASSERT_EQ(report["envelope"]["warnings"].size(), 1U);
    const auto pieces = nlohmann::json::parse(workshop.read("plan/cut/pieces.json"))["pieces"];
    ASSERT_EQ(pieces[0]["allowances_met"].size(), 1U);
    EXPECT_NEAR(pieces[0]["allowances_met"][0]["gap_m"].get<double>(), 0.030, 1e-6);
}

TEST(Allowances, ExportAndNestTellAPlanWhoseCutLineHasLostItsOpening) {
    const Workshop workshop;
    workshop.write_tiles("slotted.obj", {slotted()});
    ASSERT_EQ(workshop.ripstop("flatten slotted.obj --unit m --allowance-fit -o plan").code, 0);
    EXPECT_EQ(workshop.ripstop("export plan --dialect aama -o sound").code, 0);
    auto json = nlohmann::json::parse(workshop.read("plan/cut/pieces.json"));
    double low[2] = {10, 10}, high[2] = {-10, -10};  // of the cut line that the union of all allowances would give
    for (const auto& point : json["pieces"][0]["cut_line_m"])
        for (std::size_t k = 0; k < 2; ++k) {
            low[k] = std::min(low[k], point[k].get<double>());
            high[k] = std::max(high[k], point[k].get<double>());
        }
    json["pieces"][0]["cut_line_m"] = {{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    workshop.write("plan/cut/pieces.json", json.dump());
    const ProgramRun run = workshop.ripstop("export plan --dialect aama -o lost");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("Warning: slotted: edge"));
    EXPECT_THAT(run.err, HasSubstr("is not cut over"));
    EXPECT_EQ(workshop.ripstop("nest plan -o marker").code, 1);
    const ProgramRun validated = workshop.ripstop("validate lost/envelope.dxf");
    EXPECT_EQ(validated.code, 1) << validated.out;
    EXPECT_THAT(validated.out, HasSubstr("lost because two allowances merge"));
}

TEST(Allowances, OfAKeyholeAndARingKeepTheirOpenings) {
    for (const auto& [name, gap] :
         {std::pair("keyhole", "25 + 25 mm in a gap of 30"), std::pair("ring", "25 + 25 mm")}) {
        RIPSTOP_REQUIRE_SHARED(file, ("faults/shapes/" + std::string(name) + "_allowance.obj"));
        const Workshop workshop;
        const ProgramRun run = workshop.ripstop("flatten " + file.string() + " --unit m -o plan");
        EXPECT_EQ(run.code, 1) << run.out << run.err;
        const auto findings = findings_of(workshop, "plan");
        ASSERT_FALSE(findings.empty()) << name;
        for (const auto& finding : findings) {
            EXPECT_EQ(finding["code"], "allowances_meet") << finding;
            EXPECT_THAT(finding["message"].get<std::string>(), HasSubstr(gap));
        }
        EXPECT_EQ(workshop.ripstop("validate plan/cut/envelope.dxf").code, 0) << name;
        EXPECT_EQ(workshop.ripstop("flatten " + file.string() + " --unit m --allowance-fit -o fitted").code, 0) << name;
    }
}

}  // namespace allowances_test
}  // namespace ripstop
