#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace ripstop {

/// Writes a directory all or nothing: `write` fills one beside it, `dir.partial-PID`, which takes its name at the end; on
/// failure it is removed and `dir` is as before. Where `dir` is not empty and `force` is given, its entries called as one
/// of the globs `ours` go and all others are kept; `NAME/FILE` is a folder called so that holds a file called so.
///
/// Throws InputError with path and reason: `dir` is not empty (without `force`) or no directory, its parent is missing or
/// closed, the disk is full.
void write_whole_directory(const std::filesystem::path& dir, bool force, const std::vector<std::string_view>& ours,
                           const std::function<void(const std::filesystem::path&)>& write);

/// Throws InputError as `write_whole_directory` would for what stands at `dir`, so that a long job can say so before it
/// starts. Makes and removes a directory beside it, to try.
void require_writable(const std::filesystem::path& dir, bool force);

}  // namespace ripstop
