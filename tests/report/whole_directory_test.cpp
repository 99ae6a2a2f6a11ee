#include "ripstop/plan_folder/whole_directory.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>

#include "ripstop/base/error.h"
#include "ripstop/base/system/folder_lock.h"
#include "support/outside.h"
#include "support/refusal.h"

namespace ripstop {
namespace whole_directory_test {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<std::string_view> ours{"plan", "extra"};

void write(const std::string& dir, const std::string& text, bool force = false) {
    write_whole_directory(dir, force, ours,
                          [&](const fs::path& folder) { testing::write_text((folder / "plan").string(), text); });
}

using testing::refusal;

std::vector<std::string> names(const std::string& dir) {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(dir)) result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
}

ino_t number_of(const std::string& dir) {
    struct stat about {};
    ::stat(dir.c_str(), &about);
    return about.st_ino;
}

TEST(WholeDirectory, StaysTheFolderThatWasGivenWithItsRights) {
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("plan"));
    fs::permissions(scratch.path("plan"), fs::perms(0710));
    const ino_t before = number_of(scratch.path("plan"));
    write(scratch.path("plan"), "first");
    write(scratch.path("plan"), "second", true);
    EXPECT_EQ(number_of(scratch.path("plan")), before);
    EXPECT_EQ(fs::status(scratch.path("plan")).permissions(), fs::perms(0710));
    EXPECT_EQ(testing::content(scratch.path("plan/plan")), "second");
    EXPECT_THAT(names(scratch.path("plan")), ElementsAre("plan"));
}

TEST(WholeDirectory, IsAsBeforeWhereWritingFails) {
    const testing::ScratchDirectory scratch;
    write(scratch.path("plan"), "first");
    const auto fail = [](const fs::path& folder) {
        testing::write_text((folder / "plan").string(), "half");
        throw InputError("the disk is full");
    };
    EXPECT_THAT(refusal([&] { write_whole_directory(scratch.path("plan"), true, ours, fail); }), "the disk is full");
    EXPECT_THAT(refusal([&] { write_whole_directory(scratch.path("new"), true, ours, fail); }), "the disk is full");
    EXPECT_THAT(names(scratch.path()), ElementsAre("plan"));
    EXPECT_THAT(names(scratch.path("plan")), ElementsAre("plan"));
    EXPECT_EQ(testing::content(scratch.path("plan/plan")), "first");
}

TEST(WholeDirectory, IsOfTheFirstRunWhereAnotherFinishesMeanwhile) {
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("empty"));
    for (const std::string name : {"missing", "empty"}) {
        const std::string dir = scratch.path(name);
        const auto slow = [&](const fs::path& folder) {
            testing::write_text((folder / "plan").string(), "slow");
            testing::write_text((fs::create_directory(dir), dir + "/plan"), "fast");
        };
        EXPECT_THAT(refusal([&] { write_whole_directory(dir, false, ours, slow); }),
                    HasSubstr("another run has written into it in the meantime"));
        EXPECT_EQ(testing::content(dir + "/plan"), "fast");
        EXPECT_THAT(names(dir), ElementsAre("plan"));
        EXPECT_EQ(refusal([&] { write_whole_directory(dir, true, ours, slow); }), "accepted");
        EXPECT_EQ(testing::content(dir + "/plan"), "slow");
        EXPECT_THAT(names(dir), ElementsAre("plan"));
    }
    EXPECT_THAT(names(scratch.path()), ElementsAre("empty", "missing"));
}

TEST(WholeDirectory, IsNotForASecondRunWhileAFirstWritesIntoIt) {
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("plan"));
    write_whole_directory(scratch.path("plan"), false, ours, [&](const fs::path& folder) {
        testing::write_text((folder / "plan").string(), "first");
        EXPECT_THAT(refusal([&] { require_writable(scratch.path("plan"), false); }),
                    HasSubstr("another run is writing into it"));
    });
    EXPECT_EQ(testing::content(scratch.path("plan/plan")), "first");
}

TEST(WholeDirectory, LosesWhatKilledRunsLeftButNotWhatRunningOnesMake) {
    const testing::ScratchDirectory scratch;
    for (const char* folder : {"plan.partial-1", "plan.partial-2", "plan.trial-1", "plan.partial", "other.partial-1"})
        fs::create_directory(scratch.path(folder));
    const FolderLock alive(scratch.path("plan.partial-2"));
    require_writable(scratch.path("plan"), false);
    EXPECT_THAT(names(scratch.path()), ElementsAre("other.partial-1", "plan.partial", "plan.partial-2"));
}

TEST(WholeDirectory, TakesAFolderAsEmptyThatHoldsOnlyWhatKilledRunsLeft) {
    const testing::ScratchDirectory scratch;
    fs::create_directories(scratch.path("plan/.ripstop-partial-1"));
    fs::create_directories(scratch.path("plan/.ripstop-trial-1"));
    testing::write_text(scratch.path("plan/.ripstop-partial-1/plan"), "half");
    require_writable(scratch.path("plan"), false);
    EXPECT_THAT(names(scratch.path("plan")), IsEmpty());
}

TEST(WholeDirectory, IsTheOldOneOrTheNewOneWhereverTheLastRenamesAreKilled) {
    const testing::ScratchDirectory scratch;
    const auto make = [&](const std::string& name, const std::vector<std::string>& files) {
        for (const std::string& file : files) {
            fs::create_directories(fs::path(scratch.path(name + "/" + file)).parent_path());
            testing::write_text(scratch.path(name + "/" + file), file.ends_with(".all-moved") ? "" : file);
        }
        require_writable(scratch.path(name), true);
    };
    // Killed while the old entries moved out, while the new ones moved in, or before the old ones were removed.
    make("out", {".ripstop-partial-7/plan", ".ripstop-partial-7/extra", ".ripstop-old-7/plan", "extra", "photos"});
    EXPECT_THAT(names(scratch.path("out")), ElementsAre("extra", "photos", "plan"));
    EXPECT_EQ(testing::content(scratch.path("out/plan")), ".ripstop-old-7/plan");
    make("in", {".ripstop-partial-7/plan", ".ripstop-old-7/.all-moved", ".ripstop-old-7/plan", ".ripstop-old-7/extra",
                "extra", "photos"});
    EXPECT_THAT(names(scratch.path("in")), ElementsAre("extra", "photos", "plan"));
    EXPECT_EQ(testing::content(scratch.path("in/plan")), ".ripstop-partial-7/plan");
    EXPECT_EQ(testing::content(scratch.path("in/extra")), "extra");
    make("end", {".ripstop-old-7/plan", "plan", "photos"});
    EXPECT_THAT(names(scratch.path("end")), ElementsAre("photos", "plan"));
    EXPECT_EQ(testing::content(scratch.path("end/plan")), "plan");
}

}  // namespace whole_directory_test
}  // namespace ripstop
