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
/// plain line elsewhere, once it takes more than two seconds; nothing when `quiet`.
class Waiting {
  public:
    Waiting(std::string what, bool quiet);
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    ~Waiting();

  private:
    void tell_how_long();

    std::string what_;
    std::mutex guard_;
    std::condition_variable changed_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace ripstop::cli
