#pragma once

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

/// Runs a program to its end: `arguments[0]` is its path, or a name looked up in PATH; no shell reads them. Standard
/// input is empty and standard output discarded. After `timeout` seconds it is killed.
ChildEnd run_child(const std::vector<std::string>& arguments, double timeout);

}  // namespace ripstop
