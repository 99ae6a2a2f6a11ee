#include "ripstop/report/json/exchange_entries.h"

#include <fstream>
#include <utility>
#include <vector>

#include "ripstop/base/system/folder_lock.h"

namespace ripstop {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view partial_start = ".ripstop-partial-", old_start = ".ripstop-old-",
                           trial_start = ".ripstop-trial-";

/// A file in the folder of old entries: every old entry has moved there, so new ones may move in.
constexpr const char* all_moved = ".all-moved";

std::vector<fs::path> names_in(const fs::path& folder) {
    std::vector<fs::path> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    return names;
}

/// Moves that can be undone.
class Moves {
  public:
    void move(const fs::path& from, const fs::path& to) {
        fs::rename(from, to);
        done_.emplace_back(from, to);
    }
    void undo() {
        std::error_code ignored;
        for (auto each = done_.rbegin(); each != done_.rend(); ++each) fs::rename(each->second, each->first, ignored);
    }

  private:
    std::vector<std::pair<fs::path, fs::path>> done_;
};

fs::path old_folder(const fs::path& partial) {
    return partial.parent_path() / (std::string(old_start) + partial.filename().string().substr(partial_start.size()));
}

/// Settles an exchange that was killed. By its progress, `partial` exists alone, then `partial` and `old`, then
/// `old` alone.
void settle(const fs::path& partial, const fs::path& folder) {
    const fs::path old = old_folder(partial);
    if (fs::exists(old)) {
        const bool is_finished = fs::exists(old / all_moved);
        const fs::path& from = is_finished ? partial : old;
        for (const fs::path& name : names_in(from)) fs::rename(from / name, folder / name);
    }
    fs::remove_all(partial);
    fs::remove_all(old);
}

}  // namespace

fs::path trial_folder(const fs::path& folder, const std::string& id) {
    return folder / (std::string(trial_start) + id);
}

fs::path exchange_folder(const fs::path& folder, const std::string& id) {
    return folder / (std::string(partial_start) + id);
}

bool is_exchange_folder(const fs::path& entry) {
    return entry.filename().string().starts_with(".ripstop-");
}

void exchange_entries(const fs::path& made, const fs::path& folder,
                      const std::function<bool(const fs::path&)>& is_old) {
    Moves moves;
    fs::path partial = made;
    // If the folder did not exist, `made` is beside it. Move it inside, because a kill is settled by the folder's
    // entries.
    if (made.parent_path() != folder) {
        partial = exchange_folder(folder, made.filename().string());
        moves.move(made, partial);
    }
    const fs::path old = old_folder(partial);
    try {
        fs::create_directory(old);
        for (const fs::path& name : names_in(folder))
            if (!is_exchange_folder(name) && (is_old(folder / name) || fs::exists(partial / name)))
                moves.move(folder / name, old / name);
        std::ofstream(old / all_moved).close();
        for (const fs::path& name : names_in(partial)) moves.move(partial / name, folder / name);
    } catch (const fs::filesystem_error&) {
        std::error_code ignored;
        fs::remove(old / all_moved, ignored);
        moves.undo();
        fs::remove(old, ignored);
        throw;
    }
    fs::remove(partial);
    fs::remove_all(old);
}

void settle_dead_exchanges(const fs::path& folder) {
    for (const fs::path& name : names_in(folder)) {
        if (name.string().starts_with(trial_start)) fs::remove(folder / name);
        if (name.string().starts_with(partial_start) && !is_locked(folder / name)) settle(folder / name, folder);
    }
    for (const fs::path& name : names_in(folder))
        if (name.string().starts_with(old_start) &&
            !fs::exists(folder / (std::string(partial_start) + name.string().substr(old_start.size()))))
            fs::remove_all(folder / name);
}

}  // namespace ripstop
