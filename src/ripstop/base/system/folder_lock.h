#pragma once

#include <filesystem>

namespace ripstop {

/// An advisory lock on a folder, shared by all processes on this file system; the system gives it back when its owner
/// ends in whatever way. It follows the folder when that is renamed. Where the file system has no locks, it holds
/// nothing.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder);  ///< waits until no other process holds it
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_ = -1;
};

/// Whether a process, this one included, holds the lock of a folder. True if that cannot be told.
bool is_locked(const std::filesystem::path& folder);

}  // namespace ripstop
