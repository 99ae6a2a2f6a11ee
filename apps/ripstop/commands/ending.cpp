#include "commands/ending.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <thread>

#include "ripstop/base/system/leftover.h"

namespace ripstop::cli {
namespace {

// A signal handler may do little more than write to a pipe; a thread reads it.
std::array<int, 2> told{-1, -1};

void tell_thread(int signal) {
    const auto number = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = ::write(told[1], &number, 1);
}

void end_when_told() {
    unsigned char number = 0;
    while (::read(told[0], &number, 1) != 1) continue;
    remove_leftovers();
    std::signal(number, SIG_DFL);
    ::kill(::getpid(), number);
}

}  // namespace

void end_cleanly_on_signals() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    if (::pipe2(told.data(), O_CLOEXEC) != 0) return;
    std::thread(end_when_told).detach();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction action {};
        ::sigaction(signal, nullptr, &action);
        if (action.sa_handler == SIG_IGN) continue;
        action = {};
        action.sa_handler = tell_thread;
        action.sa_flags = SA_RESTART;
        ::sigaction(signal, &action, nullptr);
    }
}

}  // namespace ripstop::cli
