#pragma once

#include <filesystem>
#include <fstream>

namespace ripstop {

/// A file opened to be read as bytes. `what` names it in messages, such as `the project file`. Throws InputError for a folder,
/// for a pipe or a device, which might never end, and for a file that is not there or closed.
std::ifstream open_input(const std::filesystem::path& path, const char* what = "the file");

}  // namespace ripstop
