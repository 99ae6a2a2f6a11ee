#include "ripstop/base/system/leftover.h"

#include <algorithm>
#include <mutex>
#include <system_error>
#include <vector>

namespace ripstop {
namespace {

// A signal ends the whole process, so one list holds everything to remove.
std::mutex guard;
std::vector<std::filesystem::path>& watched() {
    static std::vector<std::filesystem::path> paths;
    return paths;
}

void remove_now(const std::filesystem::path& path) {
    std::error_code ignored;
    // Another thread may still write into the folder; a second pass removes what it added.
    for (int pass = 0; pass < 3 && std::filesystem::exists(path, ignored); ++pass)
        std::filesystem::remove_all(path, ignored);
}

void forget(const std::filesystem::path& path) {
    const auto found = std::find(watched().begin(), watched().end(), path);
    if (found != watched().end()) watched().erase(found);
}

}  // namespace

Leftover::Leftover(std::filesystem::path path) : path_(std::move(path)) {
    const std::lock_guard lock(guard);
    watched().push_back(path_);
}

Leftover::~Leftover() {
    if (!is_watched_) return;
    const std::lock_guard lock(guard);
    remove_now(path_);
    forget(path_);
}

void Leftover::finish(const std::function<void()>& rename) {
    const std::lock_guard lock(guard);
    rename();
    forget(path_);
    is_watched_ = false;
}

void remove_leftovers() {
    guard.lock();
    for (const std::filesystem::path& path : watched()) remove_now(path);
}

}  // namespace ripstop
