#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "ripstop/base/progress.h"

namespace ripstop::cli {

/// A bar with the time left on stderr where that is a terminal, a plain line every tenth of the work elsewhere, nothing
/// when `quiet`. The bar is wiped when the work is done.
Progress progress_bar(bool quiet);

/// Work whose end nobody can foresee, while this lives: `Reading envelope.3dm, 4 s` on a terminal, wiped at the end; one
/// plain line elsewhere, once it takes more than two seconds, and one for each tenth that `progress` tells of then;
/// nothing
/// when `quiet`.
class Waiting {
  public:
    Waiting(std::string what, bool quiet);
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    ~Waiting();

    /// Says where the work is: `Reading envelope.3dm: face 12 of 160, 4 s`. Not to be called when this is gone.
    Progress progress();

  private:
    void tell_how_long();
    void tell_on_terminal(std::unique_lock<std::mutex>& lock);
    void tell_in_lines(std::unique_lock<std::mutex>& lock);

    std::string what_, where_;
    int tenths_ = 0;
    std::mutex guard_;
    std::condition_variable changed_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace ripstop::cli
