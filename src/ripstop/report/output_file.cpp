#include "ripstop/report/output_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "ripstop/base/error.h"

namespace ripstop {

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    errno = 0;
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (out) write(out);
    // Not before the file is closed is it known that the disk took it.
    out.close();
    if (out) return;
    const std::string reason = errno != 0 ? std::generic_category().message(errno) : "the disk may be full";
    throw InputError(path.string() + ": cannot be written: " + reason);
}

void write_file(const std::filesystem::path& path, const std::string& text) {
    write_file(path, [&text](std::ostream& out) { out.write(text.data(), static_cast<std::streamsize>(text.size())); });
}

void replace_file(const std::filesystem::path& path, const std::string& text) {
    const std::filesystem::path partial = path.string() + ".partial";
    std::error_code error;
    try {
        write_file(partial, text);
    } catch (...) {
        std::filesystem::remove(partial, error);
        throw;
    }
    std::filesystem::rename(partial, path, error);
    if (!error) return;
    const std::string reason = error.message();
    std::filesystem::remove(partial, error);
    throw InputError(path.string() + ": cannot be replaced: " + reason);
}

}  // namespace ripstop
