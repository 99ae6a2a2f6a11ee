/// `ripstop export --dialect` and `ripstop validate` on the command line.
#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "ripstop/io/dxf/dxf_dialect.h"
#include "support/program.h"

namespace ripstop {
namespace pattern_files_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;

/// Flattens two tiles into `plan`.
void flatten(const Workshop& workshop, const std::string& options = "", const std::string& plan = "plan") {
    workshop.write_tiles("two.obj", {testing::flat_tile("A"), testing::bent_tile("B")});
    const ProgramRun run = workshop.ripstop("flatten two.obj --unit m --quiet -o " + plan + " " + options);
    ASSERT_LE(run.code, 1) << run.err;
}

TEST(ExportCommand, WritesEveryDialectIntoAFolderOfItsOwnAsFlattenDoes) {
    const Workshop workshop;
    flatten(workshop);
    for (const DxfDialect& dialect : dxf_dialects()) {
        const bool is_usual = dialect.name == "cam";
        const ProgramRun run = workshop.ripstop("export plan --dialect " + dialect.name);
        ASSERT_EQ(run.code, 0) << run.err;
        const std::string folder = is_usual ? "plan/cut-dxf" : "plan/cut-" + dialect.name;
        EXPECT_THAT(run.out, HasSubstr("2 pieces: " + folder));
        const auto files = workshop.files(folder);
        ASSERT_EQ(files.size(), 3U);
        EXPECT_EQ(files.count("envelope.dxf") + files.count("tiles/A.dxf") + files.count("tiles/B.dxf"), 3U);
        for (const auto& [name, text] : files) {
            const ProgramRun checked = workshop.ripstop("validate " + folder + "/" + name);
            EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
            EXPECT_THAT(checked.out, HasSubstr("verdict        sound\n"));
        }
        flatten(workshop, "--dxf-dialect " + dialect.name, "plan-" + dialect.name);
        EXPECT_EQ(workshop.read("plan-" + dialect.name + "/cut/envelope.dxf"), files.at("envelope.dxf"));
        EXPECT_EQ(workshop.read("plan-" + dialect.name + "/cut/tiles/A.dxf"), files.at("tiles/A.dxf"));
    }
    EXPECT_EQ(workshop.ripstop("validate plan/cut/envelope.svg").code, 0);
}

TEST(ExportCommand, StatesADateOnlyWhereOneIsGiven) {
    const Workshop workshop;
    flatten(workshop);
    workshop.ripstop("export plan --dialect aama -o none");
    EXPECT_THAT(workshop.read("none/envelope.dxf"), Not(HasSubstr("Creation")));
    workshop.ripstop("export plan --dialect aama --date 2026-11-02 -o given");
    EXPECT_THAT(workshop.read("given/envelope.dxf"), HasSubstr("Creation Date: 11-02-2026"));
    ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
    workshop.ripstop("export plan --dialect clo -o epoch");
    ::setenv("SOURCE_DATE_EPOCH", "yesterday", 1);
    const ProgramRun wrong = workshop.ripstop("export plan --dialect clo -o wrong");
    ::unsetenv("SOURCE_DATE_EPOCH");
    EXPECT_THAT(workshop.read("epoch/envelope.dxf"), HasSubstr("CREATION DATE: 02-01-1970"));
    EXPECT_EQ(wrong.code, 3);
    EXPECT_THAT(wrong.err, HasSubstr("SOURCE_DATE_EPOCH is \"yesterday\""));
    for (const char* date : {"2026-13-01", "2026-02-30", "2.11.2026", "2026-1-1x"}) {
        const ProgramRun run = workshop.ripstop(std::string("export plan --date ") + date + " -o no");
        EXPECT_EQ(run.code, 2) << date;
        EXPECT_THAT(run.err, HasSubstr("expected YYYY-MM-DD"));
    }
}

TEST(ExportCommand, RefusesADialectItDoesNotKnowBeforeItWrites) {
    const Workshop workshop;
    flatten(workshop);
    const ProgramRun run = workshop.ripstop("export plan --dialect lectra");
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.err, HasSubstr("known: cam, aama, astm, gerber, clo, et"));
    EXPECT_EQ(workshop.ripstop("export plan --grain-axis z").code, 2);
    EXPECT_EQ(workshop.ripstop("flatten two.obj --unit m -o other --dxf-dialect lectra").code, 2);
    EXPECT_EQ(workshop.names(), (std::vector<std::string>{"plan", "two.obj"}));
}

TEST(ValidateCommand, ReportsWhatIsWrongAndEndsWithOne) {
    const Workshop workshop;
    flatten(workshop);
    std::string text = workshop.read("plan/cut/tiles/A.dxf");
    const std::size_t flag = text.find(" 70\r\n1\r\n 10");
    ASSERT_NE(flag, std::string::npos);
    text[flag + 5] = '0';  // opens the cut line
    workshop.write("open.dxf", text);
    const ProgramRun run = workshop.ripstop("validate open.dxf");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("WRONG          A: "));
    EXPECT_THAT(run.out, HasSubstr("verdict        not sound\n"));
    const ProgramRun quiet = workshop.ripstop("validate --quiet open.dxf");
    EXPECT_EQ(quiet.code, 1);
    EXPECT_THAT(quiet.out + quiet.err, IsEmpty());
    EXPECT_EQ(workshop.ripstop("validate plan/cut/tiles/A.dxf --roll 0.5m").code, 1);
    EXPECT_EQ(workshop.ripstop("validate plan/cut/tiles/A.dxf --unit in").code, 1);
}

TEST(ValidateCommand, EndsWithThreeForWhatItCannotRead) {
    const Workshop workshop;
    workshop.write("no.dxf", "no DXF\n");
    workshop.write("no.svg", "<svg");
    workshop.write("no.pdf", "%PDF");
    EXPECT_THAT(workshop.ripstop("validate no.dxf").err, HasSubstr("no.dxf:1: "));
    for (const char* file : {"no.dxf", "no.svg", "no.pdf", "nothing.dxf", "no.dxf --roll 3"})
        EXPECT_EQ(workshop.ripstop(std::string("validate ") + file).code, 3) << file;
    EXPECT_EQ(workshop.ripstop("validate no.dxf --unit yard").code, 2);
    EXPECT_EQ(workshop.ripstop("validate").code, 2);
}

TEST(ValidateCommand, PrintsJsonAsItsSchemaSays) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    const Workshop workshop;
    flatten(workshop);
    workshop.write("empty.svg", "<svg/>");
    workshop.write("sound.json", workshop.ripstop("validate --json plan/cut/envelope.dxf").out);
    workshop.write("poor.json", workshop.ripstop("validate --json --roll 0.1m empty.svg").out);
    const nlohmann::json sound = nlohmann::json::parse(workshop.read("sound.json"));
    EXPECT_EQ(sound["square_mm"], 100);
    EXPECT_EQ(sound["contours"].size(), 4U);
    workshop.write("check.py",
                   "import json, sys, jsonschema\n"
                   "schema, *reports = (json.load(open(name)) for name in sys.argv[1:])\n"
                   "jsonschema.Draft202012Validator.check_schema(schema)\n"
                   "for report in reports:\n"
                   "    jsonschema.validate(report, schema, jsonschema.Draft202012Validator)\n");
    const auto run = testing::run_command(python + " " + workshop.path("check.py") +
                                          " " RIPSTOP_SOURCE_DIR "/docs/validate.schema.json " +
                                          workshop.path("sound.json") + " " + workshop.path("poor.json"));
    EXPECT_EQ(run.code, 0) << run.output;
}

}  // namespace pattern_files_test
}  // namespace ripstop
