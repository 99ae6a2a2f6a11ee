#pragma once

#include <cstdio>
#include <string>

namespace ripstop::cli {

/// Prints on stderr. That nobody can read it there is no reason to fail.
inline void tell(const std::string& text) {
    std::fputs(text.c_str(), stderr);
}

}  // namespace ripstop::cli
