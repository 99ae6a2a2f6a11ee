#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace ripstop {

/// Writes a folder all or nothing. `write` fills a partial folder, whose entries take their place at the end; on
/// failure the partial folder is removed and `dir` is as before.
///
/// If `dir` does not exist, the partial folder stands beside it, `dir.partial-PID`, and takes its name. If it exists,
/// it stays the folder it is (a mounted one, the current one, its owner and rights): the partial folder stands in it,
/// `dir/.ripstop-partial-PID`, and its entries move up. With `force`, entries of `dir` called as one of the globs
/// `ours` go and all others are kept; `NAME/FILE` is a folder called so that holds a file called so.
///
/// Several processes may write one folder at once: one wins whole. Without `force` the others throw, with it the last
/// one stays. What a killed process left in or beside `dir` is removed, or finished if the kill came between the last
/// renames.
///
/// `require` is called last before the entries take their place, while no other run writes into `dir`; if it throws,
/// `dir` is as before. A folder that did not exist needs no such check.
///
/// Throws InputError with path and reason: `dir` is not empty (without `force`) or no directory, its parent is missing
/// or closed, the disk is full.
void write_whole_directory(const std::filesystem::path& dir, bool force, const std::vector<std::string_view>& ours,
                           const std::function<void(const std::filesystem::path&)>& write,
                           const std::function<void()>& require = {});

/// Throws InputError as `write_whole_directory` would for what stands at `dir`, so that a long job can say so before it
/// starts. Removes what killed processes left there; makes and removes a folder, to try.
void require_writable(const std::filesystem::path& dir, bool force);

}  // namespace ripstop
