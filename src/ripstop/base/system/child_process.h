#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ripstop {

/// How a program that was started ended.
struct ChildEnd {
    enum class How { exited, killed, timed_out, not_started };
    How how = How::not_started;
    int code = 0;            ///< its exit code, the signal that killed it, or the error number of its start
    std::string complaints;  ///< the last 64 kB of what it wrote to standard error
};

/// Told each line a program writes to standard error as soon as it is whole; true: the line is taken, and no complaint.
using TakesLine = std::function<bool(const std::string& line)>;

/// Runs a program to its end: `arguments[0]` is its path, or a name looked up in PATH; no shell reads them. Standard
/// input is empty and standard output discarded; open files without FD_CLOEXEC are its own too. After `timeout` seconds
/// it is killed. It is killed as well (on Linux) when this process ends before it, however that happens.
ChildEnd run_child(const std::vector<std::string>& arguments, double timeout, const TakesLine& takes_line = {});

}  // namespace ripstop
