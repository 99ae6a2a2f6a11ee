#pragma once

#include <filesystem>
#include <fstream>

namespace ripstop {

/// Throws InputError for a folder, and for a pipe or a device, which might never end.
void require_plain_file(const std::filesystem::path& path);

/// A file opened to be read as bytes. `what` names it in messages, such as `the project file`. Throws InputError as
/// `require_plain_file`, and for a file that is not there or closed.
std::ifstream open_input(const std::filesystem::path& path, const char* what = "the file");

}  // namespace ripstop
