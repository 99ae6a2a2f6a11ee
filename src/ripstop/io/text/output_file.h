#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace ripstop {

/// Writes a file through `write`, or with `text` as its content. Throws InputError with the path and the system's
/// reason if a byte cannot be written (a protected directory, a full disk).
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void write_file(const std::filesystem::path& path, const std::string& text);

/// Writes a file all or nothing: under a temporary name beside it, then renamed. An existing file is replaced, or
/// stays as it was if anything fails. Throws as `write_file` does.
void replace_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
void replace_file(const std::filesystem::path& path, const std::string& text);

}  // namespace ripstop
