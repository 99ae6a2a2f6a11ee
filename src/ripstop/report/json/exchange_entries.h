#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace ripstop {

/// `folder/.ripstop-partial-ID`: where new entries are made.
std::filesystem::path exchange_folder(const std::filesystem::path& folder, const std::string& id);

/// `folder/.ripstop-trial-ID`: made and removed to see whether the folder can be written.
std::filesystem::path trial_folder(const std::filesystem::path& folder, const std::string& id);

/// Whether an entry is a folder that a process keeps for itself in a folder it writes into.
bool is_exchange_folder(const std::filesystem::path& entry);

/// Moves all entries of `partial` into `folder` and removes `partial`. Entries of `folder` that `is_old` names go
/// first, and so do those whose names are taken. The moves are all undone if one fails. A process that is killed
/// between them leaves enough for `settle_dead_exchanges` to undo or finish them. Throws
/// std::filesystem::filesystem_error.
///
/// Preconditions: the caller holds the FolderLock of `folder` and of `partial`; `partial` is on the file system of
/// `folder`.
void exchange_entries(const std::filesystem::path& partial, const std::filesystem::path& folder,
                      const std::function<bool(const std::filesystem::path&)>& is_old);

/// Undoes or finishes the exchanges of processes that are gone, and removes what they left. Precondition: the caller
/// holds the FolderLock of `folder`.
void settle_dead_exchanges(const std::filesystem::path& folder);

}  // namespace ripstop
