#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ripstop {

/// A record of file contents, so a result is only written next to the input that it was computed from.
class Unchanged {
  public:
    /// Reads the files; a file may be missing. O(bytes).
    explicit Unchanged(std::vector<std::filesystem::path> files);

    /// Throws InputError if the contents of a file have changed: another run has written it in the meantime.
    void require() const;

  private:
    std::vector<std::filesystem::path> files_;
    std::vector<std::string> sums_;  // SHA-256; empty where a file is missing
};

}  // namespace ripstop
