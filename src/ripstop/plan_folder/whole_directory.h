#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace ripstop {

/// Writes a folder all or nothing. `write` fills a partial folder, whose entries move into place at the end. On
/// failure, the partial folder is removed and `dir` is unchanged.
///
/// If `dir` does not exist, the partial folder `dir.partial-PID` is made beside it and renamed to `dir`. If it exists,
/// the folder itself is kept (it may be a mount point or the current directory, and it has its owner and permissions):
/// the partial folder `dir/.ripstop-partial-PID` is made inside, and its entries move up. With `force`, entries of
/// `dir` that match one of the globs `ours` are removed, and all others are kept; `NAME/FILE` matches a folder of that
/// name that contains such a file.
///
/// Several processes may write one folder at once; exactly one result is kept, complete. Without `force`, the other
/// processes throw; with it, the last one wins. Remains of a killed process in or beside `dir` are removed, or
/// completed if it was killed between the last renames.
///
/// `require` is called last before the entries move into place, while no other run can write into `dir`; if it throws,
/// `dir` is unchanged. It is not called for a folder that did not exist.
///
/// Throws InputError with path and reason: `dir` is not empty (without `force`) or not a directory, its parent is
/// missing or not writable, or the disk is full.
void write_whole_directory(const std::filesystem::path& dir, bool force, const std::vector<std::string_view>& ours,
                           const std::function<void(const std::filesystem::path&)>& write,
                           const std::function<void()>& require = {});

/// Throws the InputError that `write_whole_directory` would throw for the current state of `dir`, so a long job can
/// fail before it starts. Removes remains of killed processes; creates and removes a folder as a test.
void require_writable(const std::filesystem::path& dir, bool force);

}  // namespace ripstop
