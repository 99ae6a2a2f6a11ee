#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ripstop {

/// How a child process ended.
struct ChildEnd {
    enum class How { exited, killed, timed_out, not_started };
    How how = How::not_started;
    int code = 0;            ///< its exit code, the signal that killed it, or the error number of its start
    std::string complaints;  ///< the last 64 kB of what it wrote to standard error
};

/// Receives each complete line that a program writes to standard error. Returns true if it consumes the line;
/// otherwise the line counts as a complaint.
using TakesLine = std::function<bool(const std::string& line)>;

/// Runs a program to its end. `arguments[0]` is its path or a name to look up in PATH; no shell is involved. Standard
/// input is empty and standard output is discarded; the child inherits open files without FD_CLOEXEC. The child is
/// killed after `timeout` seconds, and (on Linux) when this process ends first, for whatever reason.
ChildEnd run_child(const std::vector<std::string>& arguments, double timeout, const TakesLine& takes_line = {});

}  // namespace ripstop
