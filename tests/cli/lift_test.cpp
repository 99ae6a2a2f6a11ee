/// `ripstop lift` and `ripstop export --tile` on the command line.
#include <gmock/gmock.h>

#include <numbers>
#include <sstream>

#include "ripstop/geometry/types.h"
#include "support/program.h"

namespace ripstop {
namespace lift_test {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;

/// The plan of a small balloon: 24 tiles in 4 patterns of 6 each.
class LiftCommand : public ::testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(workshop.ripstop("design natural --gores 6 --panels 4 --volume 20 --edge 300mm -o small.obj").code,
                  0);
        ASSERT_LE(workshop.ripstop("flatten small.obj --unit m --quiet -o plan").code, 1);
    }
    /// Adds a line across the sheet, on the layer `art`, to a file of the plan.
    void draw_on(const std::string& file, const std::string& as,
                 const std::string& drawn = "<path d=\"M0 150 L9000 151\"/>") const {
        std::string text = workshop.read(file);
        text.insert(text.rfind("</svg>"), "<g inkscape:groupmode=\"layer\" inkscape:label=\"art\">" + drawn + "</g>");
        workshop.write(as, text);
    }
    /// The length of each line of an OBJ.
    std::vector<double> lengths(const std::string& file) const {
        std::istringstream in(workshop.read(file));
        std::vector<Vec3> points;
        std::vector<double> found;
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::string key;
            words >> key;
            if (key == "v") {
                Vec3 point;
                words >> point.x() >> point.y() >> point.z();
                points.push_back(point);
            } else if (key == "l") {
                double length = 0;
                std::size_t from = 0, to = 0;
                for (words >> from; words >> to; from = to) length += (points.at(to - 1) - points.at(from - 1)).norm();
                found.push_back(length);
            }
        }
        return found;
    }
    Workshop workshop;
};

TEST_F(LiftCommand, PutsALineOnThePieceItWasDrawnOn) {
    draw_on("plan/cut/tiles/G04P02.svg", "drawn.svg");
    const ProgramRun run = workshop.ripstop("lift plan drawn.svg -o art.obj");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(workshop.read("art.obj"), HasSubstr("o art G04P02\n"));
    EXPECT_THAT(workshop.read("art.obj"), Not(HasSubstr("G01P02")));
}

TEST_F(LiftCommand, LiftsArcsRoundCornersAndCurvesAsTheyAreDrawn) {
    // Circles of 100 mm, the first one half: as an arc, as a rectangle that is all corners, and as four Bézier
    // curves.
    draw_on(
        "plan/cut/tiles/G04P02.svg", "drawn.svg",
        "<path d=\"M500 600a100 100 0 01200 0\"/><rect x=\"500\" y=\"500\" width=\"200\" height=\"200\" rx=\"100\"/>"
        "<path d=\"M500 600c0 55.228 44.772 100 100 100s100-44.772 100-100-44.772-100-100-100-100 44.772-100 100z\"/>");
    const ProgramRun run = workshop.ripstop("lift plan drawn.svg --layer art -o art.obj");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const std::vector<double> found = lengths("art.obj");
    ASSERT_EQ(found.size(), 3U);
    // The cloth of such a coarse balloon is strained by less than 3 % there; the circles agree with each other.
    EXPECT_NEAR(found[1], 2 * std::numbers::pi * 0.1, 0.03 * found[1]);
    EXPECT_NEAR(found[0], found[1] / 2, 0.005 * found[1]);
    EXPECT_NEAR(found[2], found[1], 0.001 * found[1]);
}

TEST_F(LiftCommand, NamesWhatIsDrawnAndCannotBeLifted) {
    const std::string image = "<image x=\"500\" y=\"500\" width=\"9\" height=\"9\"/>";
    draw_on("plan/cut/tiles/G04P02.svg", "both.svg", image + "<path d=\"M500 600h200\"/>");
    const ProgramRun both = workshop.ripstop("lift plan both.svg -o art.obj");
    EXPECT_EQ(both.code, 0) << both.err;
    EXPECT_THAT(both.err, HasSubstr("Warning: left out: line "));
    EXPECT_THAT(both.err, HasSubstr("1 image on layer art at (500.00, -500.00) mm"));
    draw_on("plan/cut/tiles/G04P02.svg", "image.svg", image);
    const ProgramRun alone = workshop.ripstop("lift plan image.svg -o none.obj");
    EXPECT_EQ(alone.code, 3);
    EXPECT_THAT(alone.err, HasSubstr("nothing that is drawn on its pieces can be lifted: line "));
}

TEST_F(LiftCommand, WritesNothingWhereThereIsNothingToLift) {
    draw_on("plan/cut/tiles/G04P02.svg", "drawn.svg");
    const ProgramRun run = workshop.ripstop("lift plan drawn.svg --layer nix -o art.obj");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("no line on a layer called nix; there are lines on art"));
    const ProgramRun bare = workshop.ripstop("lift plan plan/cut/envelope.dxf -o art.obj");
    EXPECT_EQ(bare.code, 3);
    EXPECT_THAT(bare.err, HasSubstr("its pieces have only their own lines"));
    EXPECT_EQ(workshop.names(), (std::vector<std::string>{"drawn.svg", "plan", "small.obj"}));
}

TEST_F(LiftCommand, TellsThePiecesOfAnotherPlanApart) {
    ASSERT_EQ(workshop.ripstop("design natural --gores 6 --panels 4 --volume 20.1 --edge 300mm -o other.obj").code, 0);
    ASSERT_LE(workshop.ripstop("flatten other.obj --unit m --quiet -o other").code, 1);
    draw_on("other/cut/tiles/G04P02.svg", "drawn.svg");
    const ProgramRun run = workshop.ripstop("lift plan drawn.svg -o art.obj");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("contains none of the plan's pieces, only G04P02"));
}

TEST_F(LiftCommand, SaysWhichCutLinesAreNoPieces) {
    draw_on("plan/cut/tiles/G04P02.svg", "drawn.svg");
    std::string text = workshop.read("drawn.svg");
    text.insert(text.rfind("</svg>"),
                "<g data-name=\"mine\"><path class=\"cut\" d=\"M9000 0 L9100 0 L9100 50 Z\"/></g>");
    workshop.write("drawn.svg", text);
    const ProgramRun run = workshop.ripstop("lift plan drawn.svg -o art.obj");
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.err,
                HasSubstr("1 cut line matches no piece of the plan, and the lines drawn there are left out: mine"));
}

TEST_F(LiftCommand, ExportOfSomePiecesCountsThese) {
    const ProgramRun run = workshop.ripstop("export plan --tile G04* --tile G05* --dialect astm -o some");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(workshop.read("some/tiles/G04P02.dxf"), HasSubstr("Quantity: 2,0"));
    EXPECT_THAT(workshop.read("some/tiles/G05P02.dxf"), HasSubstr("Quantity: 0,0"));
    ASSERT_EQ(workshop.ripstop("export plan --tile G07* --tile G01P02 --dialect astm -o one").code, 0);
    const std::string first = workshop.read("one/tiles/G01P02.dxf");
    EXPECT_THAT(first, HasSubstr("Quantity: 1,0"));
    EXPECT_THAT(first, Not(HasSubstr("\ncut "))) << "the count it had in the whole plan";
}

TEST_F(LiftCommand, ExportForceKeepsAnEnvelopeThatIsNoCutFile) {
    ASSERT_EQ(workshop.ripstop("export plan -o out").code, 0);
    workshop.write("out/envelope.obj", "mine");
    ASSERT_EQ(workshop.ripstop("export plan -o out --force").code, 0);
    EXPECT_EQ(workshop.read("out/envelope.obj"), "mine");
}

TEST_F(LiftCommand, ExportTakesTheFormatThatItsOptionsAreFor) {
    EXPECT_THAT(workshop.ripstop("export plan --paper a3").out, HasSubstr("plan/cut-pdf-a3"));
    EXPECT_EQ(workshop.files("plan/cut-pdf-a3").size(), 1U);
    ASSERT_EQ(workshop.ripstop("export plan --frame 1.2m -o frames").code, 0);
    EXPECT_EQ(workshop.files("frames").count("envelope.plt"), 1U);
    EXPECT_EQ(workshop.files("frames").count("envelope.dxf"), 0U);
    const ProgramRun unheeded = workshop.ripstop("export plan --dialect clo --format svg -o no");
    EXPECT_EQ(unheeded.code, 2);
    EXPECT_THAT(unheeded.err, HasSubstr("--dialect does not apply to svg, only to dxf"));
    EXPECT_EQ(workshop.ripstop("export plan --paper a4 --format dxf -o no").code, 2);
    EXPECT_EQ(workshop.ripstop("export plan --date 2026-11-22 --format svg,hpgl -o no").code, 2);
    EXPECT_EQ(workshop.ripstop("flatten small.obj --unit m --paper a4 --format dxf -o no").code, 2);
    ASSERT_LE(workshop.ripstop("flatten small.obj --unit m --frame 1.2m --quiet -o all").code, 1);
    EXPECT_EQ(workshop.files("all").count("cut/envelope.plt") + workshop.files("all").count("cut/envelope.dxf"), 2U);
}

}  // namespace lift_test
}  // namespace ripstop
