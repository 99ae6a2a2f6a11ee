#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <memory>

#include "tell.h"

namespace ripstop::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct State {
    Clock::time_point start = Clock::now();
    Clock::time_point drawn;
    int tenths = 0;
};

void draw(State& state, double fraction, const std::string& what) {
    const auto now = Clock::now();
    if (fraction < 1 && now - state.drawn < std::chrono::milliseconds(50)) return;
    state.drawn = now;
    const double spent = std::chrono::duration<double>(now - state.start).count();
    const int width = 32;
    const int full = static_cast<int>(fraction * width);
    tell(fmt::format("\r\033[K[{:#>{}}{:.>{}}] {:3.0f} %  {:.0f} s left  {:.24}", "", full, "", width - full,
                     100 * fraction, fraction > 0 ? spent / fraction - spent : 0, what));
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

}  // namespace ripstop::cli
