#include <gmock/gmock.h>

#include <filesystem>

#include "ripstop/flatten/method.h"
#include "support/program.h"

namespace ripstop {
namespace exit_codes_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::ProgramRun;
using ::testing::StartsWith;

/// Each test runs in a folder with one sound envelope.
class ExitCode : public ::testing::Test {
  protected:
    ExitCode() { workshop.write_tiles("envelope.obj", {testing::flat_tile()}); }

    /// Expects that a run stops before it writes anything: one sentence on stderr, nothing on stdout.
    void expect_refused(int code, const std::string& arguments, const std::string& sentence) {
        SCOPED_TRACE("ripstop " + arguments);
        const std::vector<std::string> before = workshop.names();
        const ProgramRun run = workshop.ripstop(arguments);
        EXPECT_EQ(run.code, code);
        EXPECT_THAT(run.err, HasSubstr(sentence));
        EXPECT_THAT(run.err, HasSubstr("ripstop: "));
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_EQ(workshop.names(), before);
    }
    void expect_refused_input(const std::string& file, const std::string& text, const std::string& sentence) {
        workshop.write(file, text);
        expect_refused(3, "flatten " + file + " -o plan", sentence);
    }

    testing::Workshop workshop;
};

TEST_F(ExitCode, Is0WhereEveryTileCanBeMade) {
    workshop.write_tiles("good.obj", {testing::flat_tile(), testing::bent_tile()});
    EXPECT_EQ(workshop.ripstop("flatten good.obj -o plan").code, 0);
}

TEST_F(ExitCode, Is1WhereATileCannotBeMadeAndAllFilesAreThere) {
    workshop.write_tiles("some.obj", {testing::flat_tile(), testing::curved_tile()});
    const ProgramRun run = workshop.ripstop("flatten some.obj -o plan");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, HasSubstr("1 of 2 tiles manufacturable"));
    EXPECT_THAT(workshop.read("plan/report.json"), HasSubstr("\"manufacturable\": false"));
    EXPECT_THAT(workshop.read("plan/cut/tiles/sphere.dxf"), Not(IsEmpty()));
    EXPECT_THAT(workshop.read("plan/flat/sphere.obj"), Not(IsEmpty()));
}

TEST_F(ExitCode, Is2ForAWrongCommandLine) {
    expect_refused(2, "", "a command is missing; known: flatten, check, inspect, compare, methods, design");
    expect_refused(2, "flaten envelope.obj", "no command \"flaten\"; did you mean flatten?");
    expect_refused(2, "design", "a command is missing; known: natural");
    expect_refused(2, "design sphere -o x.obj", "no command \"sphere\"; known commands: natural");
    expect_refused(2, "--bogus", "no option \"--bogus\"");
    expect_refused(2, "flatten envelope.obj -o plan --bogus", "--bogus");
    expect_refused(2, "flatten envelope.obj", "--output is required");
    expect_refused(2, "flatten -o plan", "INPUT is required");
    expect_refused(2, "flatten envelope.obj more.obj -o plan", "more.obj");
    expect_refused(2, "flatten envelope.obj -o plan --jobs -1", "--jobs");
    expect_refused(2, "flatten envelope.obj -o plan --jobs many", "--jobs");
    expect_refused(2, "flatten envelope.obj -o plan --grain 400", "--grain");
    expect_refused(2, "flatten envelope.obj -o plan --grain nan", "\"nan\" is not a number");
    expect_refused(2, "flatten envelope.obj -o plan --unit", "--unit");
    expect_refused(2, "design natural", "--output is required");
    expect_refused(2, "design natural -o x.obj --panels 4 --panel-height 2m", "excludes");
    expect_refused(2, "design natural -o x.obj --edge 1m --triangles 100", "excludes");
}

TEST_F(ExitCode, Is2ForANameThatTheProgramDoesNotKnowWithThoseItKnows) {
    expect_refused(2, "flatten envelope.obj -o plan --unit yd", "no unit \"yd\"; known: mm, cm, m, in, ft");
    expect_refused(2, "flatten envelope.obj -o plan --method foo", "no method \"foo\"; known: ");
    for (const Method& method : methods())
        expect_refused(2, "flatten envelope.obj -o plan --method foo",
                       std::string(" ").append(method.name).append(","));
    expect_refused(2, "flatten envelope.obj -o plan --method foo", ", given\n");
}

TEST_F(ExitCode, Is3ForAFileThatCannotBeUsed) {
    expect_refused(3, "flatten none.obj -o plan", "none.obj: the file cannot be opened");
    expect_refused(3, "flatten . -o plan", ".: is a folder");
    workshop.write("envelope.blend", "no mesh");
    expect_refused(3, "flatten envelope.blend -o plan",
                   "envelope.blend: a file of Blender, which is not read, expected one of: .obj");
    expect_refused_input("empty.obj", "", "empty.obj: no face");
    expect_refused_input("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "points.obj: no face");
    expect_refused_input("comma.obj", "v 0 0 0\nv 1 0,5 0\nv 0 1 0\nf 1 2 3\n",
                         "comma.obj:2: found \"0,5\", expected a finite number with a decimal point");
    expect_refused_input("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "index.obj:4: a face refers to vertex 4");
    expect_refused_input("binary.obj", std::string("\x89PNG\0\0", 6), "binary.obj:1: a zero byte");
}

TEST_F(ExitCode, Is3ForASurfaceThatIsNoTileNamedWithThePlace) {
    const std::string frame =  // a square around a square hole
        "o frame\nv 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\n"
        "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    expect_refused_input("hole.obj", frame,
                         "tile frame: has 2 boundary loops, the shortest through (1.0000, 1.0000, 0.0000) m");
    expect_refused_input("two.obj", "o two\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n",
                         "tile two: is in more than one piece; one of them is at (5.0000, 0.0000, 0.0000) m");
    expect_refused_input("closed.obj",
                         "o tet\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n",
                         "tile tet: is closed");
    expect_refused_input("flipped.obj", "o up\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n",
                         "face opposite ways");
    // All faults at once.
    workshop.write("both.obj", frame + "o flat\nv 0 0 0\nv 1 0 0\nv 2 0 0\nf -3 -2 -1\n");
    expect_refused(3, "flatten both.obj -o plan", "tile frame: ");
    expect_refused(3, "flatten both.obj -o plan", "tile flat: a triangle without area");
    // Beside a sound tile they are findings, reported only if asked for.
    workshop.write("some.obj", workshop.read("both.obj") + "o good\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
    EXPECT_EQ(workshop.ripstop("flatten some.obj -o plan").code, 1);
    EXPECT_EQ(workshop.ripstop("flatten some.obj --tile good -o other").code, 0);
}

// A fabric is a preset or the user's own file, so a name that is neither is a missing input.
TEST_F(ExitCode, Is3ForAFabricThatIsNotThereOrMakesNoSense) {
    expect_refused(3, "flatten envelope.obj -o plan --fabric silk", "no fabric \"silk\"; known: isotropic, nylon");
    expect_refused(3, "flatten envelope.obj -o plan --fabric silk.json", "silk.json: the fabric file cannot be opened");
    workshop.write("silk.json", R"({"name": "silk", "warp_stiffness_n_per_m": -1})");
    expect_refused(3, "flatten envelope.obj -o plan --fabric silk.json", "silk.json");
}

TEST_F(ExitCode, Is3ForABadProjectFile) {
    expect_refused(3, "flatten envelope.obj -o plan --project none.json",
                   "none.json: the project file cannot be opened");
    expect_refused(3, "flatten envelope.obj -o plan --project .", ".: is a folder");
    const auto expect_bad = [&](const std::string& project, const std::string& sentence) {
        workshop.write("project.json", project);
        expect_refused(3, "flatten envelope.obj -o plan --project project.json", sentence);
    };
    expect_bad("{\"unit\": ", "project.json");
    expect_bad(R"({"unit": "yd"})", "project.json: no unit \"yd\"");
    expect_bad(R"({"units": "mm"})", "project.json");
    expect_bad(R"({"fabric": "silk"})", "no fabric \"silk\"");
    expect_bad(R"({"tiles": [{"name": "plane", "warp": {"direction": [0, 0, 0]}}]})", "the warp has no direction");
    expect_bad(R"({"tiles": [{"name": "plane", "warp": {"direction": [0, 0, 1]}}]})", "is perpendicular to the tile");
}

TEST_F(ExitCode, Is3WhereThePlanCannotBePut) {
    expect_refused(3, "flatten envelope.obj -o missing/plan", "is not a directory; make it first");
    expect_refused(3, "flatten envelope.obj -o envelope.obj", "envelope.obj: is a file");
    expect_refused(3, "flatten envelope.obj -o ''", "has no name");
    expect_refused(3, "flatten envelope.obj -o .", "is not empty");
}

TEST_F(ExitCode, Is3WhereADirectoryIsNotEmptyUnlessForced) {
    ASSERT_EQ(workshop.ripstop("flatten envelope.obj -o plan --quiet").code, 0);
    workshop.write("plan/notes.txt", "mine");
    const auto before = workshop.files("plan");
    expect_refused(3, "flatten envelope.obj -o plan --method lscm", "plan: is not empty");
    EXPECT_EQ(workshop.files("plan"), before);
    workshop.write_tiles("other.obj", {testing::flat_tile("other")});
    EXPECT_EQ(workshop.ripstop("flatten other.obj -o plan --force").code, 0);
    const auto after = workshop.files("plan");
    EXPECT_EQ(after.count("flat/other.obj"), 1u);
    EXPECT_EQ(after.count("flat/plane.obj"), 0u);
    EXPECT_EQ(after.at("notes.txt"), "mine");
    EXPECT_THAT(workshop.names(), ElementsAre("envelope.obj", "other.obj", "plan"));
}

TEST_F(ExitCode, Is3WhereStandardOutputTakesNothing) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const std::string program = "cd '" + workshop.path("") + "' && " + testing::tested_program();
    EXPECT_EQ(testing::run_command("(" + program + " methods > /dev/full)").code, 3);
    EXPECT_EQ(testing::run_command("(" + program + " flatten envelope.obj -o plan --json > /dev/full)").code, 3);
}

TEST_F(ExitCode, DoesNotDependOnWhetherTheProgressIsRead) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const std::string program = "cd '" + workshop.path("") + "' && " + testing::tested_program();
    EXPECT_EQ(testing::run_command("(" + program + " flatten envelope.obj -o plan 2> /dev/full)").code, 0);
    EXPECT_EQ(testing::run_command("(" + program + " flatten none.obj -o other 2> /dev/full)").code, 3);
}

}  // namespace exit_codes_test
}  // namespace ripstop
