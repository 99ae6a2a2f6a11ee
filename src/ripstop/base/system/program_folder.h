#pragma once

#include <filesystem>

namespace ripstop {

/// The folder of the running program, with links resolved; empty if the system does not tell. The program finds its
/// installed files from there, so a prefix can be moved.
std::filesystem::path program_folder();

}  // namespace ripstop
