#pragma once

#include <string>

namespace ripstop::testing {

/// A Python interpreter that has `module`, for independent readers of our files; empty if there is none.
std::string python_with(const std::string& module);

/// The output of a command on stdout and stderr, and its exit code.
struct CommandResult {
    int code = -1;
    std::string output;
};
CommandResult run_command(const std::string& command);

/// A new directory for the running test, removed at the end of its scope. A second one needs another `purpose`.
class ScratchDirectory {
  public:
    explicit ScratchDirectory(const std::string& purpose = "");
    ~ScratchDirectory();
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;
    std::string path(const std::string& name = "") const { return name.empty() ? path_ : path_ + "/" + name; }

  private:
    std::string path_;
};

/// The content of a file.
std::string content(const std::string& path);
void write_text(const std::string& path, const std::string& text);

}  // namespace ripstop::testing
