#pragma once

#include <filesystem>
#include <fstream>

namespace ripstop {

/// Throws InputError for a folder, and for a pipe or a device, which might never end.
void require_plain_file(const std::filesystem::path& path);

/// Opens a file to read its bytes. `what` names it in messages, such as `the project file`. Throws InputError as
/// `require_plain_file` does, and for a file that does not exist or may not be read.
std::ifstream open_input(const std::filesystem::path& path, const char* what = "the file");

}  // namespace ripstop
