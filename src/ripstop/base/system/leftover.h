#pragma once

#include <filesystem>
#include <functional>

namespace ripstop {

/// A file or folder that must not outlive the work on it: a partial result or a temporary folder. The destructor
/// removes it with its contents; if a signal ends the process first, `remove_leftovers` does. Nothing removes it
/// after `kill -9`.
class Leftover {
  public:
    explicit Leftover(std::filesystem::path path);
    ~Leftover();
    Leftover(const Leftover&) = delete;
    Leftover& operator=(const Leftover&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Runs `rename`, which gives the finished path its final name, then stops watching the path. If the program
    /// handles signals with `remove_leftovers`, no signal ends the process in between. If `rename` throws, the path
    /// stays a leftover.
    void finish(const std::function<void()>& rename);

  private:
    std::filesystem::path path_;
    bool is_watched_ = true;
};

/// Removes every leftover of this process, then blocks threads that create or finish one. Call it to end the process,
/// from a thread of its own (it waits for a running `finish`), never from a signal handler.
void remove_leftovers();

}  // namespace ripstop
