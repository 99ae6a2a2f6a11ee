#include "ripstop/io/text/input_file.h"

#include <string>

#include "ripstop/base/error.h"

namespace ripstop {

void require_plain_file(const std::filesystem::path& path) {
    std::error_code unknown;
    const std::filesystem::file_status status = std::filesystem::status(path, unknown);
    if (std::filesystem::is_directory(status))
        throw InputError(path.string() + ": is a folder, expected a file; name the file in it");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        throw InputError(path.string() +
                         ": is a pipe or a device, expected a file; save what comes from it and name that");
}

std::ifstream open_input(const std::filesystem::path& path, const char* what) {
    require_plain_file(path);
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path.string() + ": " + what + " cannot be opened; check its name and its permissions");
    return in;
}

}  // namespace ripstop
