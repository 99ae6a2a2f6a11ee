#include <gmock/gmock.h>

#include <fstream>

#include "ripstop/flatten/method.h"
#include "ripstop/io/mesh/obj.h"
#include "ripstop/numeric/symmetric_solver.h"
#include "ripstop/version.h"
#include "support/program.h"

namespace ripstop {
namespace other_commands_test {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ProgramRun;
using ::testing::StartsWith;
using testing::Workshop;

TEST(TopLevel, SaysItsVersionLicenceAndLibraries) {
    const Workshop workshop;
    const ProgramRun run = workshop.ripstop("--version");
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.out, StartsWith(std::string("ripstop ").append(version).append("\n")));
    EXPECT_THAT(run.out, HasSubstr("Apache-2.0; built with " + numeric_libraries()));
    EXPECT_THAT(run.err, IsEmpty());
}

TEST(TopLevel, ExplainsEachCommandOnStdout) {
    const Workshop workshop;
    for (const char* const command :
         {"", "flatten", "check", "compare", "methods", "design", "design natural", "nest", "diff"}) {
        const ProgramRun run = workshop.ripstop(std::string(command) + " --help");
        EXPECT_EQ(run.code, 0) << command;
        EXPECT_THAT(run.out, HasSubstr("Usage: ripstop")) << command;
        EXPECT_THAT(run.err, IsEmpty()) << command;
    }
}

TEST(MethodsCommand, ListsEveryMethodOfTheTable) {
    const Workshop workshop;
    const ProgramRun run = workshop.ripstop("methods");
    EXPECT_EQ(run.code, 0);
    for (const Method& method : methods()) {
        EXPECT_THAT(run.out, ContainsRegex(std::string("(^|\n)").append(method.name).append(" ")));
        EXPECT_THAT(run.out, HasSubstr(std::string(method.origin)));
    }
    EXPECT_THAT(run.out, HasSubstr("\ngiven "));
}

TEST(DesignCommand, WritesTheTilesThatFlattenReads) {
    const Workshop workshop;
    const ProgramRun run =
        workshop.ripstop("design natural --gores 3 --panels 2 --edge 1m --volume 600 -o envelope.obj");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, StartsWith("6 tiles, 2 panels per gore"));
    EXPECT_THAT(run.out, HasSubstr("right for a sphere"));
    EXPECT_THAT(workshop.names(), ElementsAre("envelope.obj"));
    std::ifstream in(workshop.path("envelope.obj"), std::ios::binary);
    std::vector<std::string> names;
    for (const NamedMesh& tile : read_obj(in, "envelope.obj").surfaces) names.push_back(tile.name);
    EXPECT_THAT(names, ElementsAre("G01P01", "G01P02", "G02P01", "G02P02", "G03P01", "G03P02"));
    // A gore of 120 degrees is beyond what cloth can do; it is written and judged all the same.
    EXPECT_EQ(workshop.ripstop("flatten envelope.obj --tile G01P01 --method lscm -o plan").code, 1);
}

TEST(DesignCommand, WritesTheFormatOfTheExtension) {
    const Workshop workshop;
    for (const std::string extension : {".ply", ".stl", ".off"}) {
        const ProgramRun run =
            workshop.ripstop("design natural --gores 3 --panels 2 --edge 1m --volume 600 -o envelope" + extension);
        EXPECT_EQ(run.code, 0) << run.err;
        const ProgramRun check = workshop.ripstop("check envelope" + extension);
        EXPECT_THAT(check.out, HasSubstr("6 tiles")) << check.err;
    }
    const ProgramRun run = workshop.ripstop("design natural -o envelope.fbx");
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("envelope.fbx: no format that can be written has the extension \".fbx\""));
}

TEST(DesignCommand, RefusesWhatMakesNoEnvelopeAndWritesNothing) {
    const Workshop workshop;
    for (const auto& [options, sentence] : {
             std::pair{"--gores 2", "the number of gores is 2; it must lie between 3 and 1000"},
             std::pair{"--panels 0", "the number of panels is 0; it must lie between"},
             std::pair{"--volume -1", "the volume is -1 m3; it must be greater than 0 m3"},
             std::pair{"--volume nan", "the volume is nan m3"},
             std::pair{"--edge 3", "--edge: \"3\" is not a length; write a number with its unit"},
             std::pair{"--edge 1mm", "million triangles, the limit is 20; give longer edges"},
             std::pair{"--triangles -5", "the number of triangles a tile is -5; it must lie between"},
             std::pair{"--panel-height 0m", "--panel-height: 0m is too little; give a length above 0"},
             std::pair{"--crown 50m", "the opening must be narrower than"},
             std::pair{"--mouth 2", "the mouth ratio is 2; it must lie between"},
             std::pair{"--lobes 100", "it must lie between 0 and 60 degrees"},
             std::pair{"--inside 10", "not above the outside 15 C: there is no lift; give a hotter inside"},
             std::pair{"--mass 10", "no natural shape exists"},
         }) {
        const ProgramRun run = workshop.ripstop(std::string("design natural -o envelope.obj ") + options);
        EXPECT_EQ(run.code, 3) << options;
        EXPECT_THAT(run.err, StartsWith("ripstop: ")) << options;
        EXPECT_THAT(run.err, HasSubstr(sentence)) << options;
        EXPECT_THAT(run.out, IsEmpty()) << options;
    }
    EXPECT_THAT(workshop.names(), IsEmpty());
}

TEST(DesignCommand, ReplacesAFileOnlyWhenForced) {
    const Workshop workshop;
    const std::string command = "design natural --gores 3 --panels 1 --edge 2m -o envelope.obj";
    workshop.write("envelope.obj", "mine");
    const ProgramRun run = workshop.ripstop(command);
    EXPECT_EQ(run.code, 3);
    EXPECT_THAT(run.err, HasSubstr("envelope.obj: exists; give another name, or --force to replace it"));
    EXPECT_EQ(workshop.read("envelope.obj"), "mine");
    EXPECT_EQ(workshop.ripstop(command + " --force").code, 0);
    EXPECT_THAT(workshop.read("envelope.obj"), StartsWith("o G01P01\n"));
}

TEST(DesignCommand, SaysBeforeItStartsThatTheFileCannotBePut) {
    const Workshop workshop;
    EXPECT_THAT(workshop.ripstop("design natural -o missing/envelope.obj").err,
                HasSubstr("is not a folder; make it first"));
    EXPECT_THAT(workshop.ripstop("design natural --force -o .").err, HasSubstr(".: is a folder; name the file"));
    EXPECT_THAT(workshop.names(), IsEmpty());
}

}  // namespace other_commands_test
}  // namespace ripstop
