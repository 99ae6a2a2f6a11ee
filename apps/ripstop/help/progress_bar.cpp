#include "help/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "help/tell.h"

namespace ripstop::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct State {
    Clock::time_point start = Clock::now();
    Clock::time_point drawn;
    int tenths = 0;
};

std::string duration(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s", seconds);
    return seconds < 6000 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void draw(State& state, double fraction, const std::string& what) {
    const auto now = Clock::now();
    if (fraction < 1 && now - state.drawn < std::chrono::milliseconds(50)) return;
    state.drawn = now;
    const double spent = std::chrono::duration<double>(now - state.start).count();
    fraction = std::clamp(fraction, 0.0, 1.0);
    const int width = 32;
    const int full = static_cast<int>(fraction * width);
    tell(fmt::format("\r\033[K[{:#>{}}{:.>{}}] {:3.0f} %  {} left  {:.24}", "", full, "", width - full, 100 * fraction,
                     duration(fraction > 0 ? spent / fraction - spent : 0), what));
    if (fraction >= 1) tell("\r\033[K");
}

void line(State& state, double fraction, const std::string& what) {
    const int tenths = static_cast<int>(fraction * 10 + 1e-9);
    if (tenths <= state.tenths) return;
    state.tenths = tenths;
    tell(fmt::format("{:3d} % done, {}\n", 10 * tenths, what));
}

}  // namespace

Progress progress_bar(bool quiet) {
    if (quiet) return {};
    const auto state = std::make_shared<State>();
    if (isatty(STDERR_FILENO))
        return [state](double fraction, const std::string& what) { draw(*state, fraction, what); };
    return [state](double fraction, const std::string& what) { line(*state, fraction, what); };
}

Waiting::Waiting(std::string what, bool quiet) : what_(std::move(what)) {
    if (!quiet) thread_ = std::thread([this] { tell_how_long(); });
}

Waiting::~Waiting() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(guard_);
        done_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

Progress Waiting::progress() {
    return [this](double fraction, const std::string& where) {
        {
            const std::lock_guard lock(guard_);
            where_ = ": " + where;
            tenths_ = static_cast<int>(fraction * 10 + 1e-9);
        }
        changed_.notify_all();
    };
}

void Waiting::tell_how_long() {
    const bool is_terminal = isatty(STDERR_FILENO) != 0;
    std::unique_lock lock(guard_);
    if (changed_.wait_for(lock, std::chrono::milliseconds(is_terminal ? 500 : 2000), [this] { return done_; })) return;
    is_terminal ? tell_on_terminal(lock) : tell_in_lines(lock);
}

void Waiting::tell_on_terminal(std::unique_lock<std::mutex>& lock) {
    const auto start = Clock::now() - std::chrono::milliseconds(500);
    do
        tell(fmt::format("\r\033[K{}{}, {}", what_, where_,
                         duration(std::chrono::duration<double>(Clock::now() - start).count())));
    while (!changed_.wait_for(lock, std::chrono::milliseconds(500), [this] { return done_; }));
    tell("\r\033[K");
}

void Waiting::tell_in_lines(std::unique_lock<std::mutex>& lock) {
    int told = tenths_;
    tell(what_ + (where_.empty() ? " …" : where_) + "\n");
    for (;;) {
        changed_.wait(lock, [&] { return done_ || tenths_ > told; });
        if (done_) return;
        told = tenths_;
        tell(what_ + where_ + "\n");
    }
}

}  // namespace ripstop::cli
