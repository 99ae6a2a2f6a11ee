#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace ripstop {

/// Told how far a long task is: the share done in [0, 1] and what is being worked on. Called from one thread at a time.
using Progress = std::function<void(double fraction, const std::string& what)>;

/// Counts the steps of a task that several threads do, and tells one at a time. `progress` must outlive it.
class StepCounter {
  public:
    /// `from`: where the progress stands when the first of `count` steps begins.
    StepCounter(double count, const Progress& progress, double from = 0)
        : count_(count), from_(from), progress_(progress) {}
    void done(const std::string& what, double steps = 1) {
        if (!progress_) return;
        const std::lock_guard lock(guard_);
        done_ += steps;
        progress_(from_ + (1 - from_) * (done_ / count_), what);
    }

  private:
    double count_, done_ = 0, from_;
    const Progress& progress_;
    std::mutex guard_;
};

}  // namespace ripstop
