#pragma once

#include <functional>
#include <string>

namespace ripstop {

/// Told how far a long task is: the share done in [0, 1] and what is being worked on. Called from one thread at a time.
using Progress = std::function<void(double fraction, const std::string& what)>;

}  // namespace ripstop
