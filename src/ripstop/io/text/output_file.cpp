#include "ripstop/io/text/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "ripstop/base/error.h"
#include "ripstop/base/system/leftover.h"

namespace ripstop {

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    errno = 0;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (out) write(out);
    // Only closing the file shows whether the disk took it.
    out.close();
    if (out) return;
    const std::string reason = errno != 0 ? std::generic_category().message(errno) : "the disk may be full";
    throw InputError(path.string() + ": cannot be written: " + reason);
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    write_file(path, [&text](std::ostream& out) { out.write(text.data(), static_cast<std::streamsize>(text.size())); });
}

void replace_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    std::error_code error;
    const bool is_there = std::filesystem::exists(path, error);
    // A device or a pipe cannot be replaced.
    if (is_there && !std::filesystem::is_regular_file(path, error)) return write_file(path, write);
    // A symbolic link stays one; its target is replaced.
    const std::filesystem::path target = is_there ? std::filesystem::canonical(path) : path;
    Leftover partial(target.string() + ".partial-" + std::to_string(::getpid()));
    write_file(partial.path(), write);
    partial.finish([&] {
        std::filesystem::rename(partial.path(), target, error);
        if (error) throw InputError(path.string() + ": cannot be replaced: " + error.message());
    });
}

void replace_file(const std::filesystem::path& path, const std::string& text) {
    replace_file(path,
                 [&text](std::ostream& out) { out.write(text.data(), static_cast<std::streamsize>(text.size())); });
}

}  // namespace ripstop
