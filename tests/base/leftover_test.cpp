#include "ripstop/base/system/leftover.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "ripstop/base/system/folder_lock.h"
#include "support/outside.h"

namespace ripstop {
namespace leftover_test {

namespace fs = std::filesystem;

TEST(Leftover, IsRemovedWithAllItHolds) {
    const testing::ScratchDirectory scratch;
    {
        const Leftover folder(scratch.path("partial"));
        fs::create_directories(folder.path() / "inner");
        testing::write_text(scratch.path("partial/inner/file"), "half");
    }
    EXPECT_FALSE(fs::exists(scratch.path("partial")));
}

TEST(Leftover, StaysUnderItsFinalNameOnceItIsFinished) {
    const testing::ScratchDirectory scratch;
    {
        Leftover file(scratch.path("partial"));
        testing::write_text(file.path().string(), "whole");
        file.finish([&] { fs::rename(file.path(), scratch.path("done")); });
        testing::write_text(scratch.path("partial"), "somebody else's");
    }
    EXPECT_EQ(testing::content(scratch.path("done")), "whole");
    EXPECT_TRUE(fs::exists(scratch.path("partial")));
}

TEST(Leftover, IsRemovedWhereItCannotBeFinished) {
    const testing::ScratchDirectory scratch;
    {
        Leftover file(scratch.path("partial"));
        testing::write_text(file.path().string(), "whole");
        EXPECT_THROW(file.finish([] { throw std::runtime_error("no room"); }), std::runtime_error);
    }
    EXPECT_FALSE(fs::exists(scratch.path("partial")));
}

TEST(FolderLock, IsHeldWhileItLivesAlsoUnderANewName) {
    const testing::ScratchDirectory scratch;
    fs::create_directory(scratch.path("a"));
    EXPECT_FALSE(is_locked(scratch.path("a")));
    {
        const FolderLock lock(scratch.path("a"));
        EXPECT_TRUE(is_locked(scratch.path("a")));
        fs::rename(scratch.path("a"), scratch.path("b"));
        EXPECT_TRUE(is_locked(scratch.path("b")));
    }
    EXPECT_FALSE(is_locked(scratch.path("b")));
}

}  // namespace leftover_test
}  // namespace ripstop
