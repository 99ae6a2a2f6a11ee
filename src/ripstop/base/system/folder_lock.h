#pragma once

#include <filesystem>

namespace ripstop {

/// An advisory lock on a folder that all processes on this file system share. The system releases it when its owner
/// ends, for whatever reason. The lock follows a folder that is renamed. It has no effect on a file system without
/// locks.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder);  ///< blocks until no other process holds it
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_ = -1;
};

/// Whether a process, this one included, holds the lock of a folder. Returns true if that is unknown.
bool is_locked(const std::filesystem::path& folder);

}  // namespace ripstop
