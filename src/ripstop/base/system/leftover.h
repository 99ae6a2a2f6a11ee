#pragma once

#include <filesystem>
#include <functional>

namespace ripstop {

/// A file or folder that must not outlive the work on it: a partial result, a temporary folder. The destructor removes
/// it with all that it holds, and `remove_leftovers` does where a signal ends the process first. Nothing removes it
/// after `kill -9`.
class Leftover {
  public:
    explicit Leftover(std::filesystem::path path);
    ~Leftover();
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Runs `rename`, which gives the finished path its final name, and then stops watching the path. No signal ends
    /// the process in between if the program handles it with `remove_leftovers`. If `rename` throws, the path is still
    /// a leftover.
    void finish(const std::function<void()>& rename);

  private:
    std::filesystem::path path_;
    bool is_watched_ = true;
};

/// Removes every leftover of this process, then blocks those who want to make or finish one: call it to end the
/// process, from a thread of its own (it waits for a running `finish`), never from a signal handler.
void remove_leftovers();

}  // namespace ripstop
