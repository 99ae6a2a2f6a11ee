/// --help, and output on a terminal.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "support/program.h"
#include "support/sanitized.h"

namespace ripstop {
namespace help_test {

using testing::CommandResult;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using ::testing::StartsWith;
using testing::Workshop;

constexpr const char* commands[] = {"",       "flatten",        "check",          "inspect",    "compare",  "methods",
                                    "design", "design natural", "design special", "export",     "validate", "nest",
                                    "diff",   "lift",           "inflate",        "completion", "manual",   "help"};

TEST(Help, SaysWhatACommandDoesHowItIsCalledAndGivesExamples) {
    const Workshop workshop;
    for (const std::string command : commands) {
        const std::string help = workshop.ripstop(command + " --help").out;
        EXPECT_THAT(help, HasSubstr("\n\nUsage: ripstop" + (command.empty() ? "" : " " + command)));
        EXPECT_THAT(help, HasSubstr("Example")) << command;
        EXPECT_THAT(help, Not(HasSubstr("TEXT:"))) << command << ": CLI11's own words";
    }
}

TEST(Help, IsPrintedByTheCommandHelpToo) {
    const Workshop workshop;
    for (const std::string command : commands) {
        const ProgramRun run = workshop.ripstop("help " + command);
        EXPECT_EQ(run.code, 0) << run.err;
        EXPECT_EQ(run.out, workshop.ripstop(command + " --help").out);
    }
}

TEST(Help, IsNoWiderThanAPageAndHasNoColoursInAPipe) {
    const Workshop workshop;
    for (const std::string command : commands) {
        std::istringstream help(workshop.ripstop(command + " --help").out);
        bool is_footer = false;
        for (std::string line; std::getline(help, line);) {
            is_footer = is_footer || line.starts_with("Examples");
            std::size_t letters = 0;
            for (const char c : line) letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
            EXPECT_LE(letters, is_footer ? 110U : 100U) << line;
            EXPECT_EQ(line.find('\033'), std::string::npos) << line;
        }
    }
}

/// The lines of the help that begin with two blanks and `ripstop`, without the remarks after them.
std::vector<std::string> examples_of(const std::string& help) {
    static const std::regex line("\n  ripstop ([^\n]*)"), remark("(  |  +#).*$");
    std::vector<std::string> examples;
    for (std::sregex_iterator it(help.begin(), help.end(), line), end; it != end; ++it)
        examples.push_back(std::regex_replace((*it)[1].str(), remark, ""));
    return examples;
}

// The examples of `lift` need a drawing made by hand; its own tests make one.
TEST(Help, GivesExamplesThatRun) {
    RIPSTOP_TOO_LONG_SANITIZED();
    for (const std::string command : commands) {
        if (command == "lift" || command == "completion" || command == "manual") continue;
        const Workshop workshop;
        workshop.write("shop.json", R"({"unit": "m"})");
        workshop.write("shape.json", R"({"edge_mm": 400, "primitives": [{"name": "BODY", "type": "ellipsoid",
            "radii_mm": [2000, 2000, 2000], "sectors": 6, "rings": 3}]})");
        const std::string design = "design natural --gores 12 --panels 6 --edge 600mm --volume 300 -o ";
        ASSERT_EQ(workshop.ripstop(design + "envelope.obj").code, 0);
        const bool needs_plans = command == "export" || command == "validate" || command == "nest" ||
                                 command == "diff" || command == "inflate";
        for (const std::string folder : {"cut-plan", "plan-1", "plan-2"}) {
            if (!needs_plans) continue;
            ASSERT_LE(workshop.ripstop("flatten envelope.obj --quiet -o " + folder).code, 1);
        }
        const std::vector<std::string> examples = examples_of(workshop.ripstop(command + " --help").out);
        EXPECT_GE(examples.size(), command == "design" ? 1U : 2U) << command;
        for (const std::string& example : examples) {
            if (example.starts_with("design natural -o envelope.obj"))
                std::filesystem::remove(workshop.path("envelope.obj"));
            const ProgramRun run = workshop.ripstop(example);
            EXPECT_TRUE(run.code == 0 || run.code == 1) << "ripstop " << example << ": " << run.err;
        }
    }
}

/// The output on a terminal, with these variables set.
std::string on_terminal(const Workshop& workshop, const std::string& variables, const std::string& arguments) {
    const CommandResult run = testing::run_command(
        "cd '" + workshop.path("") + "' && env -u NO_COLOR -u CLICOLOR_FORCE " + variables + " script -qec '" +
        testing::tested_program() + " " + arguments + "' /dev/null < /dev/null");
    return run.output;
}

std::string in_pipe(const Workshop& workshop, const std::string& variables, const std::string& arguments) {
    return testing::run_command("cd '" + workshop.path("") + "' && env -u NO_COLOR -u CLICOLOR_FORCE " + variables +
                                " " + testing::tested_program() + " " + arguments)
        .output;
}

TEST(Colours, AreShownWhereTheyAreAskedForAndHaveNoWidth) {
    const Workshop workshop;
    workshop.write_tiles("some.obj", {testing::flat_tile(), testing::curved_tile()});
    const std::string arguments = "flatten some.obj --propose none --force -o plan";
    std::string colours = in_pipe(workshop, "CLICOLOR_FORCE=1", arguments);
    EXPECT_THAT(colours, HasSubstr("\033[32mok\033[0m"));
    EXPECT_THAT(colours, HasSubstr("\033[31mno: "));
    EXPECT_THAT(colours, HasSubstr("\033[31m1 of 2 tiles manufacturable\033[0m"));
    const std::string plain = in_pipe(workshop, "A=1", arguments);
    EXPECT_EQ(plain.find('\033'), std::string::npos);
    EXPECT_EQ(std::regex_replace(colours, std::regex("\033\\[[0-9]*m"), ""), plain);
    EXPECT_EQ(in_pipe(workshop, "CLICOLOR_FORCE=1 NO_COLOR=1", arguments), plain);
    EXPECT_EQ(in_pipe(workshop, "CLICOLOR_FORCE=0", arguments), plain);
    EXPECT_THAT(in_pipe(workshop, "CLICOLOR_FORCE=1", "check none.obj"),
                StartsWith("\033[31mripstop:\033[0m none.obj"));
    EXPECT_THAT(in_pipe(workshop, "CLICOLOR_FORCE=1", "check --help"), HasSubstr("\033[1mUsage:\033[0m ripstop check"));
}

TEST(Colours, AreShownOnATerminalThatHasThem) {
    if (std::system("command -v script > /dev/null") != 0) GTEST_SKIP() << "no script to make a terminal";
    const Workshop workshop;
    EXPECT_THAT(on_terminal(workshop, "TERM=xterm", "check none.obj"), HasSubstr("\033[31mripstop:\033[0m"));
    EXPECT_THAT(on_terminal(workshop, "TERM=dumb", "check none.obj"), StartsWith("ripstop: none.obj"));
    EXPECT_THAT(on_terminal(workshop, "TERM=xterm NO_COLOR=1", "check none.obj"), StartsWith("ripstop: none.obj"));
}

TEST(Progress, IsABarWithTheTimeLeftOnATerminalAndWipedAtTheEnd) {
    RIPSTOP_TOO_LONG_SANITIZED();
    if (std::system("command -v script > /dev/null") != 0) GTEST_SKIP() << "no script to make a terminal";
    const Workshop workshop;
    ASSERT_EQ(workshop.ripstop("design natural --gores 12 --panels 6 --edge 600mm --volume 300 -o envelope.obj").code,
              0);
    ASSERT_LE(workshop.ripstop("flatten envelope.obj -o plan --quiet").code, 1);
    for (const char* arguments : {"flatten envelope.obj -o other", "nest plan --roll 3m --force"}) {
        const std::string shown = on_terminal(workshop, "TERM=xterm", arguments);
        EXPECT_THAT(shown, HasSubstr(" s left  ")) << arguments;
        EXPECT_THAT(shown.substr(shown.rfind(" s left  ")), HasSubstr("\r\033[K")) << arguments;
    }
    EXPECT_THAT(on_terminal(workshop, "TERM=xterm", "nest plan --roll 3m --force --quiet"),
                Not(HasSubstr(" s left  ")));
}

TEST(Progress, OfProposalsAndMarkersIsPlainLinesElsewhere) {
    const Workshop workshop;
    workshop.write_tiles("sphere.obj", {testing::curved_tile()});
    const ProgramRun run = workshop.ripstop("flatten sphere.obj -o plan");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.err, HasSubstr("100 % done, sphere\n100 % done, seams to draw in sphere\n"));
    EXPECT_THAT(workshop.ripstop("nest plan --roll 3m").err, HasSubstr("100 % done, a marker\n"));
}

}  // namespace help_test
}  // namespace ripstop
