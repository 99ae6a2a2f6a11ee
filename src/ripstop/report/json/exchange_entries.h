#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace ripstop {

/// `folder/.ripstop-partial-ID`, in which new entries are made.
std::filesystem::path exchange_folder(const std::filesystem::path& folder, const std::string& id);

/// `folder/.ripstop-trial-ID`, which is made and removed to test whether the folder can be written.
std::filesystem::path trial_folder(const std::filesystem::path& folder, const std::string& id);

/// True if an entry is a private folder of a process that writes into its parent.
bool is_exchange_folder(const std::filesystem::path& entry);

/// Moves all entries of `partial` into `folder` and removes `partial`. Entries of `folder` that `is_old` selects,
/// or whose names are taken, are removed. If a move fails, all are undone. If the process is killed,
/// `settle_dead_exchanges` can undo or finish the moves. Throws std::filesystem::filesystem_error.
///
/// Preconditions: the caller holds the FolderLock of `folder` and of `partial`; `partial` is on the file system of
/// `folder`.
void exchange_entries(const std::filesystem::path& partial, const std::filesystem::path& folder,
                      const std::function<bool(const std::filesystem::path&)>& is_old);

/// Undoes or finishes the exchanges of processes that have ended, and removes their leftovers. Precondition: the
/// caller holds the FolderLock of `folder`.
void settle_dead_exchanges(const std::filesystem::path& folder);

}  // namespace ripstop
