#pragma once

#include <stdexcept>
#include <string>

namespace ripstop {

/// The caller's fault: a file, an option or a mesh that cannot be used. The message is one sentence that names the
/// place (file, object, line or coordinates), what was found, what was expected and what to do. The only exception the
/// library throws; what the mathematics cannot do is a value instead (`SolveSummary`, `Verdict`).
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace ripstop
