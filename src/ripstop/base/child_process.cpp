#include "ripstop/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

extern char** environ;

namespace ripstop {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_complaints = 64 << 10;
constexpr int step_ms = 20;

/// Whatever is there now is added to `text`; false at the end of the stream.
bool read_some(int descriptor, std::string& text) {
    std::array<char, 4096> buffer;
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0) return errno == EINTR || errno == EAGAIN;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    if (text.size() > 2 * kept_complaints) text.erase(0, text.size() - kept_complaints);
    return count > 0;
}

/// Reads until the child has ended, which may be before the last holder of its standard error has: a program it left behind
/// must not keep us.
ChildEnd await(pid_t child, int errors, double timeout) {
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout));
    ChildEnd end;
    bool open = true;
    for (int status = 0;;) {
        pollfd watched{open ? errors : -1, POLLIN, 0};
        const int ready = ::poll(&watched, 1, step_ms);
        if (ready > 0) open = read_some(errors, end.complaints);
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child) {
            while (open && ::poll(&watched, 1, 0) > 0 && read_some(errors, end.complaints)) continue;
            end.how = WIFEXITED(status) ? ChildEnd::How::exited : ChildEnd::How::killed;
            end.code = WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status);
            return end;
        }
        if (Clock::now() < deadline) continue;
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        end.how = ChildEnd::How::timed_out;
        return end;
    }
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, double timeout) {
    std::array<int, 2> errors;
    if (::pipe2(errors.data(), O_CLOEXEC) != 0) return {ChildEnd::How::not_started, errno, {}};
    ::fcntl(errors[0], F_SETFL, O_NONBLOCK);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
    std::vector<char*> words;
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    pid_t child = 0;
    const int failed = ::posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(errors[1]);
    ChildEnd end{ChildEnd::How::not_started, failed, {}};
    if (failed == 0) end = await(child, errors[0], timeout);
    ::close(errors[0]);
    if (end.complaints.size() > kept_complaints) end.complaints.erase(0, end.complaints.size() - kept_complaints);
    return end;
}

}  // namespace ripstop
