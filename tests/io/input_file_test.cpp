#include "ripstop/io/text/input_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <iterator>

#include "ripstop/base/error.h"
#include "support/program.h"
#include "support/refusal.h"

namespace ripstop {
namespace input_file_test {

using ::testing::HasSubstr;

std::string refusal(const std::string& path) {
    return testing::refusal([&] { open_input(path, "the project file"); });
}

TEST(OpenInput, OpensAFileAndSaysWhyItCannotOpenAnythingElse) {
    const testing::ScratchDirectory scratch;
    testing::write_text(scratch.path("file"), "abc");
    std::ifstream in = open_input(scratch.path("file"));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "abc");
    EXPECT_THAT(refusal(scratch.path()), HasSubstr("is a folder"));
    EXPECT_THAT(refusal(scratch.path("absent")), HasSubstr("the project file cannot be opened"));
    EXPECT_THAT(refusal("/dev/zero"), HasSubstr("is a pipe or a device"));
    ASSERT_EQ(::mkfifo(scratch.path("pipe").c_str(), 0600), 0);
    EXPECT_THAT(refusal(scratch.path("pipe")), HasSubstr("is a pipe or a device"));
}

TEST(OpenInput, KeepsEveryReaderFromWaitingOnAPipe) {
    const testing::Workshop workshop;
    for (const char* name : {"pipe.obj", "pipe.ply", "pipe.stl", "pipe.off", "pipe.3dm", "pipe.step", "pipe.json"})
        ASSERT_EQ(::mkfifo(workshop.path(name).c_str(), 0600), 0);
    for (const char* name : {"pipe.obj", "pipe.ply", "pipe.stl", "pipe.off", "pipe.3dm", "pipe.step"}) {
        const testing::ProgramRun run = workshop.ripstop(std::string("check ") + name);
        EXPECT_EQ(run.code, 3) << name;
        EXPECT_THAT(run.err, HasSubstr("is a pipe or a device")) << name;
    }
    workshop.write_tiles("tile.obj", {testing::flat_tile()});
    for (const char* option : {"--project", "--fabric"}) {
        const testing::ProgramRun run = workshop.ripstop(std::string("check tile.obj ") + option + " pipe.json");
        EXPECT_EQ(run.code, 3) << option;
        EXPECT_THAT(run.err, HasSubstr("is a pipe or a device")) << option;
    }
}

}  // namespace input_file_test
}  // namespace ripstop
