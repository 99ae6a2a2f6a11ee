#include "ripstop/base/system/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string_view>

namespace ripstop {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_complaints = 64 << 10;
constexpr int step_ms = 20;

/// Collects what a child process writes to standard error.
class Complaints {
  public:
    Complaints(int descriptor, const TakesLine& takes_line) : descriptor_(descriptor), takes_line_(takes_line) {}

    /// Reads once, after waiting at most `milliseconds` for input.
    void read(int milliseconds) {
        pollfd watched{open_ ? descriptor_ : -1, POLLIN, 0};
        if (::poll(&watched, 1, milliseconds) > 0) open_ = read_some();
    }
    void read_rest() {
        pollfd watched{descriptor_, POLLIN, 0};
        while (open_ && ::poll(&watched, 1, 0) > 0) open_ = read_some();
        keep(line_);
    }
    std::string kept() const {
        return kept_.size() > kept_complaints ? kept_.substr(kept_.size() - kept_complaints) : kept_;
    }

  private:
    /// Reads the bytes that are available now. Returns false at the end of the stream.
    bool read_some() {
        std::array<char, 4096> buffer;
        const ssize_t count = ::read(descriptor_, buffer.data(), buffer.size());
        if (count < 0) return errno == EINTR || errno == EAGAIN;
        for (const char c : std::string_view(buffer.data(), static_cast<std::size_t>(count))) {
            line_ += c;
            if (c != '\n' && line_.size() < kept_complaints) continue;
            if (!takes_line_ || !takes_line_(line_.substr(0, line_.size() - (c == '\n' ? 1 : 0)))) keep(line_);
            line_.clear();
        }
        return count > 0;
    }
    void keep(const std::string& text) {
        kept_ += text;
        if (kept_.size() > 2 * kept_complaints) kept_.erase(0, kept_.size() - kept_complaints);
    }

    int descriptor_;
    const TakesLine& takes_line_;
    bool open_ = true;
    std::string line_, kept_;
};

/// Reads until the child ends. The child may leave behind a program that keeps standard error open; this does not
/// wait for it.
ChildEnd await(pid_t child, Complaints& complaints, double timeout) {
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout));
    ChildEnd end;
    for (int status = 0;;) {
        complaints.read(step_ms);
        const pid_t ended = ::waitpid(child, &status, WNOHANG);
        if (ended == child) {
            complaints.read_rest();
            end.how = WIFEXITED(status) ? ChildEnd::How::exited : ChildEnd::How::killed;
            end.code = WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status);
            break;
        }
        if (Clock::now() < deadline) continue;
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        end.how = ChildEnd::How::timed_out;
        break;
    }
    end.complaints = complaints.kept();
    return end;
}

/// Runs in the new process. It allocates no memory: another thread may have held the allocator's lock at the fork.
[[noreturn]] void become(char* const* words, int errors, int failure, pid_t parent) {
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
#ifdef __linux__
    // If the parent ended before this call, no signal follows: compare the parent's id.
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(0);
#else
    static_cast<void>(parent);
#endif
    const int nothing = ::open("/dev/null", O_RDWR);
    if (nothing >= 0) {
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(nothing, STDOUT_FILENO);
        if (nothing > STDERR_FILENO) ::close(nothing);
    }
    ::dup2(errors, STDERR_FILENO);
    ::execvp(words[0], words);
    const int reason = errno;
    [[maybe_unused]] const ssize_t told = ::write(failure, &reason, sizeof reason);
    ::_exit(127);
}

/// A pipe that no other program inherits; the destructor closes it.
struct Pipe {
    Pipe() { failed = ::pipe2(ends.data(), O_CLOEXEC) != 0; }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(std::size_t which) {
        if (ends[which] >= 0) ::close(ends[which]);
        ends[which] = -1;
    }
    std::array<int, 2> ends{-1, -1};
    bool failed = false;
};

}  // namespace

ChildEnd run_child(const std::vector<std::string>& arguments, double timeout, const TakesLine& takes_line) {
    std::vector<char*> words;
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    Pipe errors, failure;
    if (errors.failed || failure.failed) return {ChildEnd::How::not_started, errno, {}};
    const pid_t parent = ::getpid(), child = ::fork();
    if (child < 0) return {ChildEnd::How::not_started, errno, {}};
    if (child == 0) become(words.data(), errors.ends[1], failure.ends[1], parent);
    errors.close_end(1);
    failure.close_end(1);
    ::fcntl(errors.ends[0], F_SETFL, O_NONBLOCK);
    int reason = 0;
    ssize_t count = 0;
    do count = ::read(failure.ends[0], &reason, sizeof reason);
    while (count < 0 && errno == EINTR);
    if (count == sizeof reason) {
        ::waitpid(child, nullptr, 0);
        return {ChildEnd::How::not_started, reason, {}};
    }
    Complaints complaints(errors.ends[0], takes_line);
    return await(child, complaints, timeout);
}

}  // namespace ripstop
