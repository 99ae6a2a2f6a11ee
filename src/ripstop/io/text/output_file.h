#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace ripstop {

/// Writes a file through `write`, or with `text` as its content. Throws InputError with the path and the system's
/// reason if a byte of it cannot be written (a closed directory, a full disk).
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& path, const std::string& text);

/// The same, all or nothing: written beside it, the file takes its name at the end. A file that is there is replaced,
/// or stays as it was. Throws as `write_file`.
void replace_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void replace_file(const std::filesystem::path& path, const std::string& text);

}  // namespace ripstop
