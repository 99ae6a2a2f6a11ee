#include <gmock/gmock.h>

#include <filesystem>

#include "support/program.h"

namespace ripstop {
namespace print_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;
using testing::ProgramRun;
using ::testing::StartsWith;
using testing::Workshop;

std::vector<std::string> names(const Workshop& workshop, const std::string& folder) {
    std::vector<std::string> all;
    for (const auto& [name, bytes] : workshop.files(folder)) all.push_back(name);
    return all;
}

/// A workshop with a cut plan of two tiles.
class Print : public ::testing::Test {
  protected:
    void SetUp() override {
        workshop.write_tiles("envelope.obj", {testing::flat_tile("G01P01"), testing::bent_tile("B\u00edl\u00fd")});
        ASSERT_EQ(workshop.ripstop("flatten envelope.obj --unit m -o plan --revision B").code, 0);
    }
    Workshop workshop;
};

TEST_F(Print, FlattenWritesThePatternsAsAPdf) {
    const std::string pdf = workshop.read("plan/cut/envelope.pdf");
    EXPECT_THAT(pdf, StartsWith("%PDF-1.4"));
    EXPECT_THAT(workshop.files("plan"), Not(Contains(Key("cut/tiles/G01P01.pdf"))));
    ASSERT_EQ(workshop.ripstop("flatten envelope.obj --unit m -o again --revision B").code, 0);
    EXPECT_EQ(workshop.read("again/cut/envelope.pdf"), pdf) << "the same bytes on every run";
}

TEST_F(Print, FlattenWritesTheFormatsItIsAskedFor) {
    ASSERT_EQ(workshop.ripstop("flatten envelope.obj --unit m -o cut --formats hpgl,pdf --paper a3").code, 0);
    const auto written = names(workshop, "cut/cut");
    EXPECT_THAT(written,
                ElementsAre("envelope.pdf", "envelope.plt", "pieces.json", "tiles/Bily.plt", "tiles/G01P01.plt"));
    EXPECT_NE(workshop.read("cut/cut/envelope.pdf"), workshop.read("plan/cut/envelope.pdf"));
}

TEST_F(Print, ExportWritesSheetsAndPlotterFiles) {
    ASSERT_EQ(workshop.ripstop("export plan --format pdf,hpgl --paper a4 -o a4").code, 0);
    EXPECT_THAT(names(workshop, "a4"),
                ElementsAre("envelope.pdf", "envelope.plt", "tiles/Bily.plt", "tiles/G01P01.plt"));
    EXPECT_THAT(workshop.read("a4/tiles/G01P01.plt"), StartsWith("IN;\nPS"));
    ASSERT_EQ(workshop.ripstop("export plan --format hpgl --frame 1.2m -o frames").code, 0);
    EXPECT_THAT(workshop.read("frames/tiles/G01P01.plt"), HasSubstr("PU;FR;\n"));
    ASSERT_EQ(workshop.ripstop("export plan --format pdf --paper a4").code, 0);
    EXPECT_THAT(workshop.files("plan"), Contains(Key("cut-pdf-a4/envelope.pdf"))) << "papers stand beside each other";
    if (testing::run_command("pdfinfo -v").code != 0) GTEST_SKIP() << "no poppler-utils here";
    // a sheet of 2 m x 1 m and its hem on pages of 258 mm x 171 mm, a sheet of 1.2 m x 1 m, a cover and two maps
    const auto info = testing::run_command("pdfinfo " + workshop.path("a4/envelope.pdf"));
    EXPECT_THAT(info.output, HasSubstr("envelope.obj, revision B"));
    EXPECT_THAT(info.output, HasSubstr("Page size:       595.276 x 841.89 pts (A4)"));
}

TEST_F(Print, RefusesAPaperAndAFrameBeforeAnythingIsWritten) {
    const ProgramRun paper = workshop.ripstop("export plan --format pdf --paper a9 -o out");
    EXPECT_EQ(paper.code, 2);
    EXPECT_THAT(paper.err, HasSubstr("no paper \"a9\"; known: roll, a4"));
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj --unit m --paper 9 -o out").code, 2);
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj --unit m --format dwg -o out").code, 2);
    EXPECT_THAT(workshop.ripstop("export plan --format hpgl --frame 800 -o out").err, HasSubstr("--frame"));
    EXPECT_THAT(workshop.ripstop("export plan --format hpgl --frame 9m -o out").err,
                HasSubstr("a frame of 9.00 m; give 0.10 m to 1.64 m"));
    EXPECT_THAT(workshop.names(), ElementsAre("envelope.obj", "plan"));
}

TEST_F(Print, WritesReadableNamesWhereNoFontIsInstalled) {
    workshop.write("no-fonts.conf", "<fontconfig></fontconfig>");
    ::setenv("FONTCONFIG_FILE", workshop.path("no-fonts.conf").c_str(), 1);
    const ProgramRun run = workshop.ripstop("export plan --format pdf,hpgl -o out");
    ::unsetenv("FONTCONFIG_FILE");
    ASSERT_EQ(run.code, 0) << run.err;
    if (testing::run_command("pdfinfo -v").code != 0) GTEST_SKIP() << "no poppler-utils here";
    const auto text = testing::run_command("pdftotext " + workshop.path("out/envelope.pdf") + " -");
    EXPECT_THAT(text.output, HasSubstr("Bily")) << "its own letters are ASCII";
}

}  // namespace print_test
}  // namespace ripstop
