#pragma once

#include <sys/types.h>

#include <optional>

namespace ripstop::cad {

/// In a process split off by `fork`: it is killed when its parent ends before it, and ends where that has happened.
void end_with(pid_t parent);

/// Work done in a process split off from this one, because it may break down while it reads: this one then goes on.
///
/// Both return from the constructor, as from `fork`. Where no process can be split off, this one is the attempt itself.
class Attempt {
  public:
    Attempt();
    ~Attempt();
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;

    bool is_here() const { return child_ <= 0; }  ///< in the process that does the work
    void past() const;                            ///< there: what may break down is done

    /// In the process that waits: the exit code of the work. Nothing where it broke down before `past`: was killed,
    /// or ended
    /// by another code than 0 or `refused`. Where it is killed later this process ends by the same signal.
    std::optional<int> end(int refused) const;

  private:
    pid_t child_ = 0;
    int told_ = -1;  ///< of a pipe: read here, written there
};

}  // namespace ripstop::cad
