/// How outside events end a run: signals, closed pipes, limits, other runs, folders that it may not replace.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include "support/program.h"
#include "support/sanitized.h"

namespace ripstop {
namespace processes_test {

using ::testing::AnyOf;
using testing::CommandResult;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Workshop;

/// A workshop with `small.obj`, and with `large.obj`, whose pictures take seconds to write.
class Processes : public ::testing::Test {
  protected:
    Processes() {
        workshop.write_tiles("small.obj", {testing::flat_tile("A"), testing::bent_tile("B")});
        std::vector<NamedMesh> many;
        for (char name = 'A'; name <= 'Z'; ++name) {
            many.push_back(testing::bent_tile({name}));
            many.back().mesh.positions.col(0).array() += 3 * (name - 'A');
        }
        workshop.write_tiles("large.obj", many);
    }
    /// Runs a shell script in the workshop; `$RIPSTOP` is the program.
    CommandResult shell(const std::string& script) const {
        return testing::run_command("cd '" + workshop.path("") + "' && RIPSTOP='" + testing::tested_program() +
                                    "' bash -c '" + script + "'");
    }
    /// Starts a run with slow pictures, sends it a signal once its partial folder exists, and prints how it ended. On a
    /// busy machine the signal may come after the end: then it is tried again.
    CommandResult end_while_writing(const std::string& signal) const {
        CommandResult run;
        for (int attempt = 0; attempt < 10; ++attempt) {
            run = shell(
                "rm -rf plan; set -m; $RIPSTOP flatten large.obj --unit m --quiet --pictures -o plan & run=$!;"
                "until compgen -G \"plan.partial-*/*\" >/dev/null || ! kill -0 $run 2>/dev/null; do :; done;"
                "kill -" +
                signal + " $run; wait $run; echo ended $?");
            if (run.output.find("ended 0") == std::string::npos) break;
        }
        return run;
    }
    const Workshop workshop;
};

TEST_F(Processes, LeaveNothingBehindOnASignal) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const std::vector<std::pair<std::string, int>> ends{{"INT", 130}, {"TERM", 143}, {"HUP", 129}};
    for (const auto& [signal, code] : ends) {
        const CommandResult run = end_while_writing(signal);
        EXPECT_THAT(run.output, HasSubstr("ended " + std::to_string(code))) << signal;
        EXPECT_THAT(workshop.names(), Not(::testing::Contains(HasSubstr("partial")))) << signal;
        std::filesystem::remove_all(workshop.path("plan"));
    }
}

TEST_F(Processes, GoOnWhereTheSignalIsIgnored) {
    const CommandResult run = shell(
        "trap \"\" HUP; $RIPSTOP flatten small.obj --unit m --quiet --pictures -o plan & run=$!;"
        "until compgen -G \"plan.partial-*/*\" >/dev/null || ! kill -0 $run 2>/dev/null; do :; done;"
        "kill -HUP $run; wait $run; echo ended $?");
    EXPECT_THAT(run.output, HasSubstr("ended 0"));
}

TEST_F(Processes, RemoveWhatAKilledOneLeft) {
    const CommandResult killed = end_while_writing("KILL");
    EXPECT_THAT(killed.output, HasSubstr("ended 137"));
    EXPECT_THAT(workshop.names(), ::testing::Contains(HasSubstr("plan.partial-")));
    EXPECT_EQ(workshop.ripstop("flatten small.obj --unit m --quiet -o plan").code, 0);
    EXPECT_THAT(workshop.names(), ElementsAre("large.obj", "plan", "small.obj"));
}

TEST_F(Processes, WriteIntoTheFolderTheyStandIn) {
    const CommandResult run = shell(
        "mkdir here; cd here; $RIPSTOP flatten ../small.obj --unit m --quiet -o . && touch mine && ls report.json");
    EXPECT_THAT(run.output, HasSubstr("report.json"));
    EXPECT_TRUE(std::filesystem::exists(workshop.path("here/mine")));
}

TEST_F(Processes, WriteIntoAMountedFolder) {
    const std::string mounted =
        "mkdir -p mnt && mount -t tmpfs tmpfs mnt && $RIPSTOP flatten small.obj --unit m --quiet -o mnt && "
        "$RIPSTOP flatten small.obj --unit m --quiet --force -o mnt && ls mnt";
    const CommandResult run = shell("unshare -m bash -c \"" + mounted + "\" || echo code $?");
    if (run.output.find("unshare:") != std::string::npos || run.output.find("mount:") != std::string::npos)
        GTEST_SKIP() << "only the superuser may mount";
    EXPECT_THAT(run.output, HasSubstr("report.json"));
}

TEST_F(Processes, FinishThePlanWhereTheReaderClosesThePipe) {
    for (const char* how : {"2>&1 | head -1", "| true", "2>&1 >/dev/null | true", "--json | true"}) {
        const CommandResult run =
            shell(std::string("$RIPSTOP flatten small.obj -o plan ") + how + "; echo codes ${PIPESTATUS[0]}; ls plan");
        EXPECT_THAT(run.output, HasSubstr("codes 0")) << how;
        EXPECT_THAT(run.output, HasSubstr("report.json")) << how;
        std::filesystem::remove_all(workshop.path("plan"));
    }
}

TEST_F(Processes, WriteNoCellThatASpreadsheetRuns) {
    workshop.write_tiles("names.obj",
                         {testing::flat_tile("=cmd|"), testing::flat_tile("+1+1"), testing::flat_tile("@SUM(1+1)"),
                          testing::flat_tile("-2"), testing::flat_tile("G01")});
    ASSERT_LE(workshop.ripstop("flatten names.obj --unit m --quiet -o plan").code, 1);
    for (const char* table : {"plan/tiles.csv", "plan/seams.csv", "plan/bom.csv"}) {
        std::string text = workshop.read(table);
        text.insert(text.begin(), '\n');
        for (const char* start : {"\n=", "\n@", "\n+", ",=", ",@", ",+"})
            EXPECT_THAT(text, Not(HasSubstr(start))) << table;
    }
    const std::string tiles = workshop.read("plan/tiles.csv");
    for (const char* name : {"\n'=cmd|,", "\n'+1+1,", "\n'@SUM(1+1),", "\n-2,", "\nG01,"})
        EXPECT_THAT(tiles, HasSubstr(name));
}

TEST_F(Processes, SayThatAFileGrewBeyondItsLimit) {
    const CommandResult run = shell("ulimit -f 1; $RIPSTOP flatten small.obj --unit m --quiet -o plan; echo code $?");
    EXPECT_THAT(run.output, HasSubstr("File too large"));
    EXPECT_THAT(run.output, HasSubstr("code 3"));
    EXPECT_THAT(workshop.names(), ElementsAre("large.obj", "small.obj"));
}

TEST_F(Processes, OfWhichTwoWriteOneFolderOneWinsAndTheOtherIsTold) {
    workshop.write_tiles("other.obj", {testing::flat_tile("C")});
    for (int round = 0; round < 4; ++round) {
        const CommandResult run = shell(
            "$RIPSTOP flatten small.obj --unit m --quiet -o race & a=$!; $RIPSTOP flatten other.obj --unit m --quiet "
            "-o race;"
            "b=$?; wait $a; echo codes $? $b; ls race/flat | tr \"\\n\" \" \"");
        EXPECT_THAT(run.output,
                    AnyOf(HasSubstr("codes 0 3\nA.obj B.obj sewing.json"), HasSubstr("codes 3 0\nC.obj sewing.json")));
        EXPECT_THAT(workshop.names(), ElementsAre("large.obj", "other.obj", "race", "small.obj"));
        std::filesystem::remove_all(workshop.path("race"));
    }
}

}  // namespace processes_test
}  // namespace ripstop
