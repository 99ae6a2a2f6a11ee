/// `ripstop inspect` on the command line.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace ripstop {
namespace inspect_test {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::ProgramRun;
using testing::Workshop;
using Json = nlohmann::json;

const std::string fixtures = RIPSTOP_SOURCE_DIR "/tests/data/rhino/";

TEST(InspectCommand, SaysWhatARhinoFileHolds) {
    const ProgramRun run = Workshop().ripstop("inspect " + fixtures + "tiles_v8.3dm");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_THAT(run.out, HasSubstr("tiles_v8.3dm\nunit           in (0.0254 m)\n"));
    EXPECT_THAT(run.out, HasSubstr("layers         Default, Gores, Gores::G01, GRAIN, Off\n"));
    EXPECT_THAT(run.out, HasSubstr("surfaces       4\ncurves         2\nnot read       0\n"));
    EXPECT_THAT(run.out, HasSubstr("G01P01            Gores::G01         5          3  20  10     3  "));
    EXPECT_THAT(run.out, HasSubstr("remark         1 object on the hidden layer \"Off\" left out; "));
}

TEST(InspectCommand, SaysWhatItCouldNotReadAndWhy) {
    ::setenv("RIPSTOP_CAD", "/nowhere/ripstop-cad", 1);  // no extrusion can be read then
    const ProgramRun run = Workshop().ripstop("inspect " + fixtures + "curves_v8.3dm");
    ::unsetenv("RIPSTOP_CAD");
    EXPECT_EQ(run.code, 0) << "a file without a surface is read all the same";
    EXPECT_THAT(run.out, HasSubstr("not read       Extrusion wall on Default: an extrusion is not read; mesh it"));
}

TEST(InspectCommand, ReadsAnyFormatAndSaysWhereTheUnitIsMissing) {
    const Workshop workshop;
    workshop.write_tiles("tile.obj", {testing::flat_tile()});
    const ProgramRun run = workshop.ripstop("inspect tile.obj");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("unit           none; give --unit\n"));
    EXPECT_THAT(run.out, HasSubstr("plane    -            45         64  2  1  0  \n"));
    EXPECT_EQ(workshop.ripstop("inspect nothing.obj").code, 3);
    EXPECT_EQ(workshop.ripstop("inspect").code, 2);
}

TEST(InspectCommand, StaysShortForManyObjectsOfWhichTheJsonHasAll) {
    const Workshop workshop;
    std::vector<NamedMesh> tiles;
    for (int i = 0; i < 1000; ++i) tiles.push_back(testing::flat_tile("tile " + std::to_string(i)));
    workshop.write_tiles("many.obj", tiles);
    const ProgramRun run = workshop.ripstop("inspect many.obj");
    EXPECT_LT(std::count(run.out.begin(), run.out.end(), '\n'), 40);
    EXPECT_THAT(run.out, HasSubstr("and 980 more surfaces\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("tile 20 ")));
    const Json json = Json::parse(workshop.ripstop("inspect many.obj --json").out);
    EXPECT_EQ(json["surfaces"].size(), 1000u);
    EXPECT_EQ(json["surfaces"][999]["name"], "tile 999");
    EXPECT_EQ(json["surfaces"][999]["box_max_file_unit"], Json::array({2.0, 1.0, 0.0}));
    EXPECT_EQ(json["input"]["unit"], nullptr);
}

TEST(InspectCommand, WritesJsonThatItsSchemaAccepts) {
    const std::string python = testing::python_with("jsonschema");
    if (python.empty()) GTEST_SKIP() << "no Python with jsonschema here";
    const Workshop workshop;
    workshop.write("validate.py",
                   "import json, sys, jsonschema\n"
                   "schema, *reports = (json.load(open(name)) for name in sys.argv[1:])\n"
                   "jsonschema.Draft202012Validator.check_schema(schema)\n"
                   "for report in reports: jsonschema.Draft202012Validator(schema).validate(report)\n");
    std::string files;
    for (const char* name : {"tiles_v5", "curves_v8"}) {
        const std::string file = fmt::format("{}.json", name);
        workshop.write(file, workshop.ripstop(fmt::format("inspect --json {}{}.3dm", fixtures, name)).out);
        files += fmt::format(" {}", workshop.path(file));
    }
    const auto result = testing::run_command(python + " " + workshop.path("validate.py") +
                                             " " RIPSTOP_SOURCE_DIR "/docs/inspect.schema.json" + files);
    EXPECT_EQ(result.code, 0) << result.output;
}

}  // namespace inspect_test
}  // namespace ripstop
