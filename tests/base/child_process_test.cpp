#include "ripstop/base/system/child_process.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>

#include "support/outside.h"

namespace ripstop {
namespace child_process_test {

using How = ChildEnd::How;

/// True if a process has ended, even if nobody has waited for it.
bool is_gone(pid_t process) {
    const std::string status = testing::content("/proc/" + std::to_string(process) + "/stat");
    const std::size_t name = status.rfind(") ");
    return name == std::string::npos || status[name + 2] == 'Z';
}

TEST(ChildProcess, GivesTheExitCodeAndWhatWasComplained) {
    const ChildEnd end = run_child({"/bin/sh", "-c", "echo answer; echo complaint >&2; exit 3"}, 60);
    EXPECT_EQ(end.how, How::exited);
    EXPECT_EQ(end.code, 3);
    EXPECT_EQ(end.complaints, "complaint\n");
}

TEST(ChildProcess, ReadsNoShellIntoItsArguments) {
    EXPECT_EQ(run_child({"/bin/sh", "-c", "echo \"$1\" >&2", "sh", "$(exit 1); 'a' *"}, 60).complaints,
              "$(exit 1); 'a' *\n");
}

TEST(ChildProcess, TellsAKillFromAnExitAndFromNoStart) {
    const ChildEnd killed = run_child({"/bin/sh", "-c", "kill -SEGV $$"}, 60);
    EXPECT_EQ(killed.how, How::killed);
    EXPECT_EQ(killed.code, SIGSEGV);
    EXPECT_EQ(run_child({"/nowhere/at-all"}, 60).how, How::not_started);
}

TEST(ChildProcess, EndsWhatDoesNotEndEvenWhereAGrandchildHoldsThePipe) {
    EXPECT_EQ(run_child({"/bin/sh", "-c", "sleep 60; true"}, 0.2).how, How::timed_out);
}

TEST(ChildProcess, KeepsTheEndOfLongComplaints) {
    const ChildEnd end = run_child({"/bin/sh", "-c", "head -c 1000000 /dev/zero >&2; echo last >&2"}, 60);
    EXPECT_LE(end.complaints.size(), 64U << 10);
    EXPECT_TRUE(end.complaints.ends_with("last\n"));
}

TEST(ChildProcess, GivesEachLineAsItComesAndKeepsThoseThatNobodyTook) {
    std::vector<std::string> taken;
    const ChildEnd end = run_child({"/bin/sh", "-c", "printf 'progress 1\\noops\\nprogress 2\\nlast' >&2"}, 60,
                                   [&taken](const std::string& line) {
                                       if (!line.starts_with("progress")) return false;
                                       taken.push_back(line);
                                       return true;
                                   });
    EXPECT_EQ(taken, (std::vector<std::string>{"progress 1", "progress 2"}));
    EXPECT_EQ(end.complaints, "oops\nlast");
}

TEST(ChildProcess, EndsWithItsParentHoweverThatEnds) {
    for (const int signal : {SIGTERM, SIGHUP, SIGINT, SIGKILL}) {
        SCOPED_TRACE(signal);
        const testing::ScratchDirectory scratch;
        const std::string file = scratch.path("child");
        const pid_t parent = ::fork();
        if (parent == 0) {
            ::signal(signal, SIG_DFL);
            run_child(
                {"/bin/sh", "-c", "echo $$ > '" + file + ".new'; mv '" + file + ".new' '" + file + "'; exec sleep 60"},
                60);
            ::_exit(0);
        }
        const auto within_seconds = [](const std::function<bool()>& holds) {
            for (int i = 0; i < 1000 && !holds(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
            return holds();
        };
        ASSERT_TRUE(within_seconds([&] { return std::filesystem::exists(file); }));
        const pid_t child = std::stoi(testing::content(file));
        ASSERT_EQ(::kill(child, 0), 0);
        ::kill(parent, signal);
        ::waitpid(parent, nullptr, 0);
        EXPECT_TRUE(within_seconds([child] { return is_gone(child); }));
    }
}

}  // namespace child_process_test
}  // namespace ripstop
