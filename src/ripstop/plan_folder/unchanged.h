#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ripstop {

/// What files hold now, so that a result is written only beside the input it was computed from.
class Unchanged {
  public:
    /// Reads the files; a file may be missing. O(bytes).
    explicit Unchanged(std::vector<std::filesystem::path> files);

    /// Throws InputError if a file holds something else by now: another run has written it meanwhile.
    void require() const;

  private:
    std::vector<std::filesystem::path> files_;
    std::vector<std::string> sums_;  // SHA-256; empty where a file is missing
};

}  // namespace ripstop
