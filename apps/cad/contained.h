#pragma once

#include <sys/types.h>

#include <optional>

namespace ripstop::cad {

/// For a process made by `fork`: it is killed when its parent ends, and ends at once if that has already happened.
void end_with(pid_t parent);

/// Does work in a child process, because the work may crash while it reads; the parent then continues.
///
/// The constructor returns in both processes, as `fork` does. If no child can be made, this process does the work
/// itself.
class Attempt {
  public:
    Attempt();
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    bool is_here() const { return child_ <= 0; }  ///< true in the process that does the work
    void past() const;                            ///< in the child: the part that may crash is done

    /// In the parent: waits and returns the exit code of the work. Nothing if it failed before `past`: it was
    /// killed, or ended with a code other than 0 and `refused`. If it is killed after `past`, this process ends
    /// with the same signal.
    std::optional<int> end(int refused) const;

  private:
    pid_t child_ = 0;
    int told_ = -1;  ///< a pipe: the parent reads, the child writes
};

}  // namespace ripstop::cad
