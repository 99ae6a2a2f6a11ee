#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/program.h"

namespace ripstop {
namespace manual_test {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;

/// The completions that bash offers for the last of `words`.
std::string offered(const Workshop& workshop, const std::string& words) {
    const ProgramRun script = workshop.ripstop("completion bash");
    EXPECT_EQ(script.code, 0) << script.err;
    std::ofstream(workshop.path("complete.bash")) << script.out << "COMP_WORDS=(ripstop " << words << ")\n"
                                                  << "COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                                                  << "_ripstop\necho \" ${COMPREPLY[*]} \" > offered.txt\n";
    EXPECT_EQ(std::system(("cd '" + workshop.path("") + "' && bash complete.bash").c_str()), 0);
    return workshop.read("offered.txt");
}

TEST(Completion, OffersCommandsOptionsAndTheirWords) {
    const Workshop workshop;
    EXPECT_THAT(offered(workshop, "fl"), HasSubstr(" flatten "));
    EXPECT_THAT(offered(workshop, "fl"), Not(HasSubstr("check")));
    EXPECT_THAT(offered(workshop, "flatten --no"), HasSubstr(" --notch-spacing --notch-depth "));
    EXPECT_THAT(offered(workshop, "flatten --corners s"), HasSubstr(" square "));
    EXPECT_THAT(offered(workshop, "design n"), HasSubstr(" natural "));
    EXPECT_THAT(offered(workshop, "design natural --go"), HasSubstr(" --gores "));
    EXPECT_THAT(offered(workshop, "completion z"), HasSubstr(" zsh "));
    EXPECT_EQ(offered(workshop, "validate x.dxf --unit ''"), " mm cm m in ft \n");
    EXPECT_THAT(offered(workshop, "compare x.obj --method seam"), HasSubstr(" seam-exact "));
    EXPECT_EQ(offered(workshop, "help des"), " design \n");
}

TEST(Completion, OffersWordsBehindASignOfEqualityAndACommaToo) {
    const Workshop workshop;
    EXPECT_EQ(offered(workshop, "flatten --corners = s"), " square \n") << "as bash divides the line";
    EXPECT_EQ(offered(workshop, "flatten --corners = f"), " fold \n");
    EXPECT_EQ(offered(workshop, "flatten --corners="), " --corners=mitre --corners=square --corners=fold \n")
        << "where it does not divide there";
    EXPECT_EQ(offered(workshop, "export plan --formats dxf,s"), " dxf,svg \n");
    EXPECT_EQ(offered(workshop, "export plan --formats = dxf,svg,h"), " dxf,svg,hpgl \n");
}

TEST(Completion, OffersFilesWhereTheyBelong) {
    const Workshop workshop;
    std::ofstream(workshop.path("envelope.obj")) << "x";
    std::ofstream(workshop.path("a shop.json")) << "x";
    EXPECT_EQ(offered(workshop, "flatten env"), " envelope.obj \n");
    EXPECT_EQ(offered(workshop, "flatten envelope.obj --project a"), " a shop.json \n");
    std::filesystem::create_directory(workshop.path("folder"));
    EXPECT_EQ(offered(workshop, "flatten envelope.obj --project ''"), " folder a shop.json \n") << "no OBJ";
    EXPECT_EQ(offered(workshop, "flatten envelope.obj --fabric ny"), " nylon nylon-silicone \n");
    EXPECT_EQ(offered(workshop, "nest f"), " folder \n");
    EXPECT_EQ(offered(workshop, "nest e"), "  \n") << "a plan is a folder";
    EXPECT_EQ(offered(workshop, "flatten envelope.obj --grain ''"), "  \n") << "a number is not to be guessed";
    EXPECT_THAT(offered(workshop, "methods ''"), Not(HasSubstr("envelope.obj")));
}

TEST(Completion, IsMadeForZshAndFishAndNoOtherShell) {
    const Workshop workshop;
    EXPECT_THAT(workshop.ripstop("completion zsh").out, HasSubstr("#compdef ripstop"));
    EXPECT_THAT(
        workshop.ripstop("completion fish").out,
        HasSubstr("complete -c ripstop -n '__fish_seen_subcommand_from flatten' -l corners -x -a 'mitre square fold'"));
    EXPECT_EQ(workshop.ripstop("completion tcsh").code, 2);
}

TEST(Completion, IsTakenByFish) {
    if (std::system("command -v fish > /dev/null") != 0) GTEST_SKIP() << "no fish to ask";
    const Workshop workshop;
    std::ofstream(workshop.path("ripstop.fish")) << workshop.ripstop("completion fish").out;
    const auto offers = [&workshop](const std::string& line) {
        return testing::run_command("cd '" + workshop.path("") +
                                    "' && HOME=. fish -c 'source ripstop.fish; complete -C \"" + line + "\"'")
            .output;
    };
    EXPECT_THAT(offers("ripstop fl"), HasSubstr("flatten\tFlatten every tile"));
    EXPECT_THAT(offers("ripstop flatten --corners s"), HasSubstr("square"));
    EXPECT_THAT(offers("ripstop design natural --go"), HasSubstr("--gores"));
    EXPECT_THAT(offers("ripstop flatten --fabric ny"), HasSubstr("nylon-silicone"));
    EXPECT_THAT(offers("ripstop export p --formats dxf,s"), HasSubstr("dxf,svg"));
    EXPECT_EQ(offers("ripstop completion "), "bash\nfish\nzsh\n");
}

// Uses a terminal of its own, which zsh needs for completion.
TEST(Completion, IsTakenByZsh) {
    if (std::system("command -v zsh > /dev/null") != 0) GTEST_SKIP() << "no zsh to ask";
    const Workshop workshop;
    std::ofstream(workshop.path("_ripstop")) << workshop.ripstop("completion zsh").out;
    std::ofstream(workshop.path("ask.zsh")) << R"(zmodload zsh/zpty || exit 77
zpty z zsh -f -i
zpty -w z "fpath=(\$PWD \$fpath); autoload -U compinit; compinit -u -d dump; ripstop() { print -r -- \"\$@\" > typed.txt; }"
zpty -w z "zle-line-init() { : > ready; }; zle -N zle-line-init"
until [ -e ready ]; do sleep 0.05; done
zpty -w -n z $'ripstop fl\tenv --corn\tsq\t\n'
zpty -w z exit
zpty -r z all 'no such thing' > /dev/null
cat typed.txt
)";
    const auto asked = testing::run_command("cd '" + workshop.path("") + "' && timeout 60 zsh -f ask.zsh");
    if (asked.code == 77) GTEST_SKIP() << "no zsh/zpty";
    EXPECT_THAT(asked.output, EndsWith("flatten env --corners square\n"));
}

TEST(Manual, HasEveryCommandAndReadsWithoutWarning) {
    const Workshop workshop;
    const ProgramRun page = workshop.ripstop("manual");
    EXPECT_EQ(page.code, 0);
    for (const char* command : {"flatten", "check", "export", "validate", "lift", "design natural"})
        EXPECT_THAT(page.out, HasSubstr(std::string(".SS ripstop ") + command + "\n"));
    EXPECT_THAT(page.out, HasSubstr("\\fB\\-\\-corners\\fR \\fImitre|square|fold\\fR"));
    if (std::system("command -v groff > /dev/null") != 0) GTEST_SKIP() << "no groff to read the page with";
    std::ofstream(workshop.path("ripstop.1")) << page.out;
    EXPECT_EQ(std::system(("cd '" + workshop.path("") +
                           "' && groff -man -Tutf8 -P-cbou -ww ripstop.1 > page.txt 2> warnings.txt")
                              .c_str()),
              0);
    EXPECT_THAT(workshop.read("warnings.txt"), IsEmpty());
    const std::string text = workshop.read("page.txt");
    EXPECT_THAT(text, HasSubstr("\nEXIT STATUS\n"));
    EXPECT_LT(text.find("       INPUT  The envelope"), text.find("       -h, --help")) << text.substr(0, 2000);
    EXPECT_THAT(text, HasSubstr("\n       Flattening\n"));
    EXPECT_THAT(text, HasSubstr("\n              gerber   "));
}

}  // namespace manual_test
}  // namespace ripstop
