#include "ripstop/base/child_process.h"

#include <gtest/gtest.h>

#include <csignal>

namespace ripstop {
namespace {

using How = ChildEnd::How;

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

}  // namespace
}  // namespace ripstop
