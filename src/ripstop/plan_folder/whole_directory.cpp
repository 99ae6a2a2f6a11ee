#include "ripstop/plan_folder/whole_directory.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/system/folder_lock.h"
#include "ripstop/base/system/leftover.h"
#include "ripstop/base/text/glob.h"
#include "ripstop/report/json/exchange_entries.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

/// The absolute path with links resolved: links to the folder remain, and a partial folder can be renamed within its
/// parent.
fs::path resolved(const fs::path& dir) {
    if (dir.empty()) throw InputError("the output directory has no name; give one");
    fs::path path = fs::weakly_canonical(fs::absolute(dir)).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!path.has_filename()) throw InputError(dir.string() + ": cannot be the output directory; choose one inside it");
    return path;
}

/// `NAME/FILE` matches a folder of that name that contains such a file.
bool is_called(const fs::path& entry, std::string_view glob) {
    const std::size_t slash = glob.find('/');
    if (!glob_match(glob.substr(0, slash), entry.filename().string())) return false;
    if (slash == std::string_view::npos) return true;
    if (!fs::is_directory(entry)) return false;
    return std::any_of(fs::directory_iterator(entry), fs::directory_iterator(), [&](const auto& file) {
        return glob_match(glob.substr(slash + 1), file.path().filename().string());
    });
}

std::string process_id() {
    return std::to_string(::getpid());
}

constexpr const char *partial_end = ".partial-", *trial_end = ".trial-";

/// The partial folders beside a folder that does not exist yet.
void remove_dead_beside(const fs::path& target) {
    const FolderLock turn(target.parent_path());
    const std::string name = target.filename().string();
    std::vector<fs::path> dead;
    for (const fs::directory_entry& entry : fs::directory_iterator(target.parent_path())) {
        const std::string other = entry.path().filename().string();
        const bool is_ours = other.starts_with(name + partial_end) || other.starts_with(name + trial_end);
        if (is_ours && entry.is_directory() && !is_locked(entry.path())) dead.push_back(entry.path());
    }
    std::error_code somebody_elses;
    for (const fs::path& folder : dead) fs::remove_all(folder, somebody_elses);
}

enum class Content { none, partial, some };  ///< `partial`: another process is about to fill it

Content content_of(const fs::path& target) {
    Content content = Content::none;
    for (const fs::directory_entry& entry : fs::directory_iterator(target)) {
        if (!is_exchange_folder(entry.path())) return Content::some;
        content = Content::partial;
    }
    return content;
}

/// Tests by writing: permissions do not tell everything, since a file system may be read-only.
void require_room(const fs::path& trial, const fs::path& dir) {
    std::error_code error;
    fs::create_directory(trial, error);
    if (error)
        throw InputError(dir.string() + ": cannot be written: " + error.message() + " (" +
                         trial.parent_path().string() + "); choose another place");
    fs::remove(trial, error);
}

void require_free(const fs::path& target, const fs::path& dir) {
    const Content content = content_of(target);
    if (content == Content::some)
        throw InputError(dir.string() + ": is not empty; choose another directory, or replace it with --force");
    if (content == Content::partial)
        throw InputError(dir.string() + ": another run is writing into it; wait for it, or choose another directory");
}

/// A new partial folder, locked while this process lives: an unlocked one belongs to a dead process.
class PartialFolder {
  public:
    explicit PartialFolder(const fs::path& target)
        : stands_in_target(fs::exists(target)),
          turn_(std::in_place, stands_in_target ? target : target.parent_path()),
          folder(unused(target)),
          alive_(made(folder.path())) {
        turn_.reset();
    }

    const bool stands_in_target;

  private:
    /// A second folder of the same process gets another name.
    fs::path unused(const fs::path& target) const {
        for (int n = 1;; ++n) {
            const std::string id = process_id() + (n == 1 ? "" : "-" + std::to_string(n));
            const fs::path path =
                stands_in_target ? exchange_folder(target, id) : fs::path(target.string() + partial_end + id);
            if (!fs::exists(path)) return path;
        }
    }
    static const fs::path& made(const fs::path& path) {
        fs::create_directory(path);
        return path;
    }

    std::optional<FolderLock> turn_;

  public:
    Leftover folder;

  private:
    FolderLock alive_;
};

/// Returns false if the name exists already.
bool take_name(const fs::path& partial, const fs::path& target) {
    if (::renameat2(AT_FDCWD, partial.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0) return true;
    if (errno == EEXIST) return false;
    // File systems without RENAME_NOREPLACE: making the folder is the test, and an empty one is replaced in one step.
    if (!fs::create_directory(target)) return false;
    fs::rename(partial, target);
    return true;
}

void enter(const fs::path& partial, const fs::path& target, const fs::path& dir, bool force,
           const std::vector<std::string_view>& ours, const std::function<void()>& require) {
    const FolderLock turn(target);
    if (!force && content_of(target) == Content::some)
        throw InputError(
            dir.string() +
            ": another run has written into it in the meantime, so nothing is written; choose another directory, "
            "or replace it with --force");
    if (require) require();
    exchange_entries(partial, target, [&ours](const fs::path& entry) {
        return std::any_of(ours.begin(), ours.end(), [&](auto glob) { return is_called(entry, glob); });
    });
}

}  // namespace

void require_writable(const fs::path& dir, bool force) {
    try {
        const fs::path target = resolved(dir);
        if (!fs::exists(target)) {
            if (!fs::is_directory(target.parent_path()))
                throw InputError(dir.string() + ": cannot be written: " + target.parent_path().string() +
                                 " is not a directory; make it first");
            require_room(target.string() + trial_end + process_id(), dir);
            return remove_dead_beside(target);
        }
        if (!fs::is_directory(target)) throw InputError(dir.string() + ": is a file, expected a directory or nothing");
        require_room(trial_folder(target, process_id()), dir);
        const FolderLock turn(target);
        settle_dead_exchanges(target);
        if (!force) require_free(target, dir);
    } catch (const fs::filesystem_error& error) {
        throw InputError(dir.string() + ": cannot be written: " + error.code().message());
    }
}

void write_whole_directory(const fs::path& dir, bool force, const std::vector<std::string_view>& ours,
                           const std::function<void(const fs::path&)>& write, const std::function<void()>& require) {
    require_writable(dir, force);
    const fs::path target = resolved(dir);
    try {
        PartialFolder partial(target);
        const fs::path& made = partial.folder.path();
        write(made);
        partial.folder.finish([&] {
            if (partial.stands_in_target || !take_name(made, target)) enter(made, target, dir, force, ours, require);
        });
    } catch (const fs::filesystem_error& error) {
        throw InputError(dir.string() + ": cannot be written: " + error.code().message() + " (" +
                         error.path1().string() + ")");
    }
}

}  // namespace ripstop
