#pragma once

#include <stdexcept>
#include <string>

namespace ripstop {

/// Reports an error of the caller: a file, an option or a mesh that cannot be used. The message is one sentence. It
/// names the place (file, object, line or coordinates), what was found, what was expected and what to do. The library
/// throws no other exception; if the mathematics fails, the result says so as a value (`SolveSummary`, `Verdict`).
class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace ripstop
