/// Every command answers a mistake with one sentence in the same style and an exit code, and writes nothing.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "support/program.h"

namespace ripstop {
namespace wrong_uses_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;

struct Slip {
    const char* arguments;
    int code;
    const char* sentence;
};

/// `envelope.obj` and its plan, a folder, an empty file, a text file, a plan of another version, and truncated
/// JSON.
class WrongUse : public ::testing::TestWithParam<Slip> {
  protected:
    WrongUse() {
        workshop.write_tiles("envelope.obj", {testing::flat_tile()});
        workshop.write("empty.obj", "");
        workshop.write("empty.dxf", "");
        workshop.write("text.dxf", "a letter\n");
        workshop.write("bad.json", "{\n");
        for (const char* folder : {"folder", "old/cut"}) std::filesystem::create_directories(workshop.path(folder));
        workshop.write("old/cut/pieces.json", R"({"schema": "0.1"})");
        EXPECT_EQ(workshop.ripstop("flatten envelope.obj -o plan --quiet").code, 0);
    }
    Workshop workshop;
};

TEST_P(WrongUse, IsAnsweredInOneSentence) {
    const auto before = workshop.files(".");
    const ProgramRun run = workshop.ripstop(GetParam().arguments);
    EXPECT_EQ(run.code, GetParam().code) << run.err;
    EXPECT_THAT(run.err, HasSubstr(GetParam().sentence));
    EXPECT_THAT(run.err, MatchesRegex(GetParam().code == 2 ? "ripstop: [^\n]+\n`ripstop[a-z ]* --help` tells more\n"
                                                           : "ripstop: [^\n]+\n"));
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_EQ(workshop.files("."), before) << "something was written";
}

constexpr Slip words[] = {
    {"", 2, "a command is missing; known: flatten, check"},
    {"flaten envelope.obj", 2, "no command \"flaten\"; did you mean flatten?"},
    {"sew envelope.obj", 2, "no command \"sew\"; known commands: flatten, check"},
    {"--verison", 2, "no option \"--verison\"; did you mean --version?"},
    {"flatten envelope.obj -o p --outptu x", 2, "no option \"--outptu\"; did you mean --output?"},
    {"flatten envelope.obj -o p --untl=mm", 2, "no option \"--untl\"; did you mean --unit?"},
    {"flatten envelope.obj -o p --fast", 2, "no option \"--fast\"\n"},
    {"flatten envelope.obj more.obj -o p", 2,
     "\"more.obj\" is one word too many; expected ripstop flatten INPUT -o DIR"},
    {"flatten -o p", 2, "INPUT is required: the envelope"},
    {"flatten envelope.obj", 2, "--output is required: the folder to write"},
    {"flatten envelope.obj -o p --unit", 2, "--unit needs its value, UNIT"},
    {"flatten envelope.obj -o p --unit yards", 2, "--unit: no unit \"yards\"; known: mm, cm, m, in, ft"},
    {"flatten envelope.obj -o p --grain east", 2, "--grain: \"east\" is not a number from -360 to 360"},
    {"flatten envelope.obj -o p --jobs 1.5", 2, "--jobs: \"1.5\" is not a whole number from 0 to 1024"},
    {"flatten envelope.obj -o p --corners round", 2, "--corners: no \"round\"; known: mitre, square, fold"},
    {"flatten envelope.obj -o p --format dwg", 2, "--format: no format \"dwg\" for pieces; known: dxf, svg"},
    {"flatten envelope.obj -o p --format svg --paper a4", 2, "--paper does not apply to svg"},
    {"flatten envelope.obj -o p --date friday", 2, "--date: \"friday\" is not a date, expected YYYY-MM-DD"},
    {"flatten envelope.obj -o p --remesh often", 2, "--remesh is \"often\", expected auto, never or a length"},
    {"check", 2, "INPUT is required"},
    {"inspect envelope.obj --tiles some", 2, "--tiles: no \"some\"; known: faces, objects"},
    {"compare envelope.obj --method magic", 2, "--method: no method \"magic\"; known: seam-exact"},
    {"methods all", 2, "\"all\" is one word too many; expected ripstop methods"},
    {"design", 2, "a command is missing; known: natural"},
    {"design natrual -o a.obj", 2, "no command \"natrual\"; did you mean natural?"},
    {"design natural -o a.obj --gores two", 2, "--gores: \"two\" is not a whole number"},
    {"design natural -o a.obj --volume much", 2, "--volume: \"much\" is not a number"},
    {"design natural -o a.obj --panels 3 --panel-height 1m", 2, "--panels excludes --panel-height; give one"},
    {"export", 2, "PLAN is required: a folder that `ripstop flatten` wrote"},
    {"export plan --dialect lectra", 2, "--dialect: no DXF dialect \"lectra\"; known: cam, aama"},
    {"export plan --format pdf --paper 3cm", 2, "--paper: a roll of paper is 200 mm to 5 m wide, not 3cm"},
    {"export plan --grain-axis z", 2, "--grain-axis: no \"z\"; known: x, y"},
    {"validate plan/cut/envelope.dxf --unit yd", 2, "--unit: no unit \"yd\"; known: mm"},
    {"nest plan --effort lots", 2, "--effort: \"lots\" is not a whole number from 0 to 100000"},
    {"nest plan --grain-tolerance 90", 2, "--grain-tolerance: \"90\" is not a number from 0 to 28"},
    {"diff plan", 2, "AFTER is required"},
    {"lift plan", 2, "DRAWING is required"},
    {"completion tcsh", 2, "SHELL: no \"tcsh\"; known: bash, zsh, fish"},
    {"flatten envelope.obj -o p --method papr", 2, "given; did you mean paper?"},
    {"flatten envelope.obj -o p --propose nnone", 2, "known: auto, all, none; did you mean none?"},
    {"export plan --dialect gerbr", 2, "; did you mean gerber?"},
    {"help flaten", 2, "no command \"flaten\" of ripstop; did you mean flatten?"},
    {"help design unnatural", 2, "no command \"unnatural\" of ripstop design; did you mean natural?"},
    {"manual flatten", 2, "\"flatten\" is one word too many"},
};
INSTANTIATE_TEST_SUITE_P(OfWords, WrongUse, ::testing::ValuesIn(words));

constexpr Slip inputs[] = {
    {"flatten none.obj -o p", 3, "none.obj: the file cannot be opened; check its name"},
    {"flatten folder -o p", 3, "folder: is a folder, expected a file; name the file in it"},
    {"flatten empty.obj -o p", 3, "empty.obj: no face"},
    {"flatten text.dxf -o p", 3, "text.dxf: a file of AutoCAD DXF, which is not read, expected one of: .obj"},
    {"flatten envelope.obj -o plan", 3, "plan: is not empty; choose another directory, or replace it with --force"},
    {"flatten envelope.obj -o no/p", 3, "is not a directory; make it first"},
    {"flatten envelope.obj -o p --seam-tolerance 5", 3, "--seam-tolerance: \"5\" is not a length; write a number with"},
    {"flatten envelope.obj -o p --notch-depth 1m", 3, "--notch-depth is 1m, expected 0.5 to 50 mm"},
    {"flatten envelope.obj -o p --fabric silk", 3, "no fabric \"silk\"; known: isotropic, nylon"},
    {"flatten envelope.obj -o p --fabric nylom", 3, "; did you mean nylon?"},
    {"flatten envelope.obj -o /proc/p", 3, "/proc/p: cannot be written: "},
    {"flatten envelope.obj -o p --project bad.json", 3, "bad.json:2: not JSON"},
    {"flatten envelope.obj -o p --tile 'X*'", 3, "no tile is called \"X*\"; the input has plane"},
    {"check none.3dm", 3, "none.3dm: the file cannot be opened"},
    {"inspect folder", 3, "folder: is a folder"},
    {"compare envelope.obj --sheet no/x.svg", 3, "no/x.svg: there is no folder no; make it first"},
    {"compare envelope.obj --sheet envelope.obj", 3, "envelope.obj: is the input itself"},
    {"design natural -o a.xyz", 3,
     "a.xyz: no format that can be written has the extension \".xyz\", expected one of: .obj"},
    {"design natural -o envelope.obj", 3, "envelope.obj: exists; give another name, or --force to replace it"},
    {"design natural -o a.obj --gores 0", 3, "the number of gores is 0; it must lie between 3 and 1000"},
    {"export none", 3, "none: no cut plan in it (cut/pieces.json cannot be opened), expected a folder"},
    {"export envelope.obj", 3, "envelope.obj: is a file, expected a folder that `ripstop flatten` wrote"},
    {"export old", 3, "flatten the envelope again"},
    {"export plan --tile 'Z*'", 3, "no piece is called Z*; tiles.csv of the plan has the names"},
    {"validate folder", 3, "folder: is a folder, expected a file"},
    {"validate empty.dxf", 3, "empty.dxf"},
    {"validate text.dxf", 3, "text.dxf:1: \"a letter\" in place of a group code"},
    {"validate plan/cut/envelope.dxf --roll 0m", 3, "--roll is 0m, expected a length above 0"},
    {"nest old", 3, "old/cut/pieces.json: "},
    {"nest plan --gap -1mm", 3, "the gap between pieces is -0.001 m, expected 0 to 1 m"},
    {"nest plan --roll -1m", 3, "the roll is -1 m wide, expected a length above 0"},
    {"nest plan --roll-length 0m", 3, "a roll is 0 m long, expected a length above 0"},
    {"nest plan -o plan", 3, "plan: is part of a cut plan"},
    {"diff plan old", 3, "old/cut/pieces.json: "},
    {"lift plan text.dxf -o l.obj", 3, "text.dxf:1: "},
    {"lift plan plan/cut/envelope.dxf -o l.obj", 3, "its pieces have only their own lines, such as the sew line"},
    {"lift plan plan/cut/envelope.dxf -o envelope.obj", 3, "envelope.obj: exists; give another name"},
};
INSTANTIATE_TEST_SUITE_P(OfInputs, WrongUse, ::testing::ValuesIn(inputs));

}  // namespace wrong_uses_test
}  // namespace ripstop
