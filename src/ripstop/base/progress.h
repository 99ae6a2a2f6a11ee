#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace ripstop {

/// Receives the progress of a long task: the completed fraction in [0, 1] and the current step. Called from one
/// thread at a time.
using Progress = std::function<void(double fraction, const std::string& what)>;

/// Counts the steps that several threads complete and reports them one at a time. `progress` must outlive it.
class StepCounter {
  public:
    /// `from`: the value of the progress when the first of `count` steps begins.
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
