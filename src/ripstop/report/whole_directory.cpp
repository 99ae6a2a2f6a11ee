#include "ripstop/report/whole_directory.h"

#include <unistd.h>

#include <algorithm>
#include <string>

#include "ripstop/base/error.h"
#include "ripstop/base/glob.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

/// Absolute and without links, so that its parent is where the partial directory can be renamed from.
fs::path resolved(const fs::path& dir) {
    if (dir.empty()) throw InputError("the output directory has no name; give one");
    fs::path path = fs::weakly_canonical(fs::absolute(dir)).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    if (!path.has_filename()) throw InputError(dir.string() + ": cannot be the output directory; name one below it");
    return path;
}

/// `NAME/FILE` is a folder of that name that holds such a file.
bool is_called(const fs::path& entry, std::string_view glob) {
    const std::size_t slash = glob.find('/');
    if (!glob_match(glob.substr(0, slash), entry.filename().string())) return false;
    if (slash == std::string_view::npos) return true;
    if (!fs::is_directory(entry)) return false;
    return std::any_of(fs::directory_iterator(entry), fs::directory_iterator(), [&](const auto& file) {
        return glob_match(glob.substr(slash + 1), file.path().filename().string());
    });
}

/// Puts `fresh` in the place of `dir`. What the old one held besides ours moves along; only then does it go.
void replace(const fs::path& fresh, const fs::path& dir, const fs::path& aside,
             const std::vector<std::string_view>& ours) {
    if (!fs::exists(dir)) return fs::rename(fresh, dir);
    fs::rename(dir, aside);
    try {
        fs::rename(fresh, dir);
    } catch (const fs::filesystem_error&) {
        fs::rename(aside, dir);
        throw;
    }
    std::vector<fs::path> kept;
    for (const fs::directory_entry& entry : fs::directory_iterator(aside)) kept.push_back(entry.path().filename());
    for (const fs::path& name : kept)
        if (std::none_of(ours.begin(), ours.end(), [&](auto glob) { return is_called(aside / name, glob); }))
            fs::rename(aside / name, dir / name);
    fs::remove_all(aside);
}

/// Beside it (as written, `dir`) the partial directory is made. The rights of the folder do not tell all: a file system may take none at all.
void require_room_beside(const fs::path& target, const fs::path& dir) {
    const fs::path trial = target.string() + ".trial-" + std::to_string(::getpid());
    std::error_code error;
    fs::create_directory(trial, error);
    if (error)
        throw InputError(dir.string() + ": cannot be written: " + error.message() + " (" +
                         target.parent_path().string() + "); choose another place");
    fs::remove(trial, error);
}

}  // namespace

void require_writable(const fs::path& dir, bool force) {
    try {
        const fs::path target = resolved(dir);
        if (!fs::is_directory(target.parent_path()))
            throw InputError(dir.string() + ": cannot be written: " + target.parent_path().string() +
                             " is no directory; make it first");
        require_room_beside(target, dir);
        if (!fs::exists(target)) return;
        if (!fs::is_directory(target)) throw InputError(dir.string() + ": is a file, expected a directory or nothing");
        if (!force && !fs::is_empty(target))
            throw InputError(dir.string() + ": is not empty; choose another directory, or replace it with --force");
    } catch (const fs::filesystem_error& error) {
        throw InputError(dir.string() + ": cannot be written: " + error.code().message());
    }
}

void write_whole_directory(const fs::path& dir, bool force, const std::vector<std::string_view>& ours,
                           const std::function<void(const fs::path&)>& write) {
    require_writable(dir, force);
    const fs::path target = resolved(dir);
    const std::string id = std::to_string(::getpid());
    const fs::path partial = target.string() + ".partial-" + id;
    const fs::path aside = target.string() + ".old-" + id;
    std::error_code ignored;
    try {
        fs::remove_all(partial);
        fs::create_directory(partial);
        write(partial);
        replace(partial, target, aside, ours);
    } catch (const fs::filesystem_error& error) {
        fs::remove_all(partial, ignored);
        throw InputError(dir.string() + ": cannot be written: " + error.code().message() + " (" +
                         error.path1().string() + ")");
    } catch (...) {
        fs::remove_all(partial, ignored);
        throw;
    }
}

}  // namespace ripstop
