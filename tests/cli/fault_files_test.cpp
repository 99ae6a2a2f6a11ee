/// Files of users that were wrongly refused or accepted. `check` and `flatten` agree on them.
#include <gmock/gmock.h>

#include "support/program.h"
#include "support/shared_data.h"

namespace ripstop {
namespace fault_files_test {

using ::testing::HasSubstr;
using testing::ProgramRun;
using testing::Workshop;

struct Fault {
    const char* file;
    int code;
    const char* says;  ///< message of flatten, on either stream
};

class FaultFile : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultFile, IsJudgedAsItsTextSays) {
    const auto& [file, code, says] = GetParam();
    RIPSTOP_REQUIRE_SHARED(path, (std::string("faults/shapes/") + file));
    const Workshop workshop;
    const std::string arguments = " '" + path.string() + "' --unit m";
    const ProgramRun check = workshop.ripstop("check" + arguments);
    EXPECT_EQ(check.code, code) << check.out << check.err;
    const ProgramRun flatten = workshop.ripstop("flatten" + arguments + " --format dxf -o plan");
    EXPECT_EQ(flatten.code, code) << flatten.out << flatten.err;
    EXPECT_THAT(flatten.err + flatten.out, HasSubstr(says));
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, FaultFile,
    ::testing::Values(Fault{"belt.obj", 0, "1 of 1 tile manufacturable"},
                      Fault{"cm_read_as_m.obj", 1, "with --unit cm it would measure 3.00 m, with in 7.62 m"},
                      Fault{"repeated_corner.obj", 0, "1 of 1 tile manufacturable"},
                      Fault{"zero_area_triangle.obj", 0,
                            "1 vertex merged with another in the same place: in T, near (0.0000, 1.0000, 0.0000)"},
                      Fault{"unwelded_tip.obj", 0, "2 vertices of tips, separate for each triangle, welded: in G"}),
    [](const auto& fault) {
        const std::string file = fault.param.file;
        return file.substr(0, file.find('.'));
    });

}  // namespace fault_files_test
}  // namespace ripstop
