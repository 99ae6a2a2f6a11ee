#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "ripstop/base/progress.h"

namespace ripstop::cli {

/// Shows progress on stderr: on a terminal a bar with the remaining time, elsewhere a line for each tenth of the
/// work, nothing if `quiet`. The bar is erased when the work is done.
Progress progress_bar(bool quiet);

/// Shows that work of unknown length is going on, for the lifetime of this object. On a terminal it writes
/// `Reading envelope.3dm, 4 s` and erases it at the end. Elsewhere it writes one line after two seconds, and one
/// for each tenth that `progress` reports later. It writes nothing if `quiet`.
class Waiting {
  public:
    Waiting(std::string what, bool quiet);
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    ~Waiting();

    /// Adds the current step: `Reading envelope.3dm: face 12 of 160, 4 s`. Do not call it after this object is
    /// gone.
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
